#include "meshes/audit_boundary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "meshes/audit_cells.h"
#include "meshes/mesh_error.h"
#include "meshes/quality.h"

namespace fretval::meshes {
namespace {

using Ends = std::pair<unsigned, unsigned>;

Ends ends_of(unsigned a, unsigned b) {
  return std::minmax(a, b);
}

std::string describe_ends(const Mesh& mesh, const Ends& ends) {
  return fmt::format("edge from {} to {}", describe_node(mesh, ends.first), describe_node(mesh, ends.second));
}

std::string describe_edge(const Mesh& mesh, std::size_t edge) {
  const auto& [nodes, boundary] = mesh.edges[edge];
  return fmt::format("{} edge {} from {} to {}", boundary_name(boundary), edge, describe_node(mesh, nodes[0]),
                     describe_node(mesh, nodes[1]));
}

std::map<Ends, int> cells_per_edge(const Mesh& mesh) {
  std::map<Ends, int> n_cells;
  for (const auto& cell : mesh.cells)
    for (int i = 0; i < 4; ++i) ++n_cells[ends_of(cell[i], cell[(i + 1) % 4])];
  return n_cells;
}

/// Numbers of the boundary edges by their ends.
std::map<Ends, std::size_t> boundary_edges(const Mesh& mesh, const std::string& name) {
  std::map<Ends, std::size_t> edges;
  for (std::size_t i = 0; i < mesh.edges.size(); ++i) {
    const auto& nodes = mesh.edges[i].nodes;
    const auto [first, is_new] = edges.emplace(ends_of(nodes[0], nodes[1]), i);
    if (!is_new)
      throw MeshError(fmt::format("{}: {} is there already as {} edge {}, must be in one part of the boundary, once",
                                  name, describe_edge(mesh, i), boundary_name(mesh.edges[first->second].boundary),
                                  first->second));
  }
  return edges;
}

/// The nodes of the boundary in the order of a walk around it, from the first edge on.
std::vector<unsigned> walk_boundary(const Mesh& mesh, const std::string& name) {
  std::vector<std::vector<unsigned>> neighbours(mesh.nodes.size());
  for (const auto& edge : mesh.edges) {
    neighbours[edge.nodes[0]].push_back(edge.nodes[1]);
    neighbours[edge.nodes[1]].push_back(edge.nodes[0]);
  }
  for (unsigned i = 0; i < mesh.nodes.size(); ++i)
    if (neighbours[i].size() > 2)
      throw MeshError(fmt::format("{}: {} is on {} edges of the boundary, must be 0 or 2", name, describe_node(mesh, i),
                                  neighbours[i].size()));
  std::vector<unsigned> walk{mesh.edges[0].nodes[0]};
  unsigned next = mesh.edges[0].nodes[1];
  while (next != walk.front()) {
    const unsigned last = walk.back();
    walk.push_back(next);
    next = neighbours[next][0] == last ? neighbours[next][1] : neighbours[next][0];
  }
  return walk;
}

/// Area of a polygon, whatever its sense.
double polygon_area(const Mesh& mesh, const std::vector<unsigned>& polygon) {
  double twice = 0.;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto& a = mesh.nodes[polygon[i]];
    const auto& b = mesh.nodes[polygon[(i + 1) % polygon.size()]];
    twice += a[0] * b[1] - a[1] * b[0];
  }
  return std::abs(twice) / 2.;
}

}  // namespace

void audit_edges(const Mesh& mesh, const std::string& name) {
  const auto n_cells = cells_per_edge(mesh);
  const auto boundary = boundary_edges(mesh, name);
  for (const auto& [ends, edge] : boundary) {
    const auto found = n_cells.find(ends);
    const int n = found == n_cells.end() ? 0 : found->second;
    if (n != 1)
      throw MeshError(fmt::format("{}: {} belongs to {} cells, must be 1", name, describe_edge(mesh, edge), n));
  }
  for (const auto& [ends, n] : n_cells) {
    if (n > 2)
      throw MeshError(fmt::format("{}: {} belongs to {} cells, must be at most 2", name, describe_ends(mesh, ends), n));
    if (n == 1 && boundary.count(ends) == 0)
      throw MeshError(
          fmt::format("{}: {} belongs to 1 cell and to no part of the boundary, must be in one part, or "
                      "between 2 cells without a hanging node",
                      name, describe_ends(mesh, ends)));
  }
}

void audit_parts_of_boundary(const Mesh& mesh, const std::string& name) {
  std::map<Boundary, int> n_edges;
  for (const auto& edge : mesh.edges) ++n_edges[edge.boundary];
  for (const Boundary boundary : needed_boundaries)
    if (n_edges[boundary] == 0)
      throw MeshError(fmt::format("{}: {} has 0 edges, must have at least 1", name, boundary_name(boundary)));
  if (n_edges[Boundary::far] + n_edges[Boundary::base] == 0)
    throw MeshError(fmt::format("{}: far and base have 0 edges, one of them must have at least 1", name));
  for (std::size_t i = 0; i < mesh.edges.size(); ++i) {
    const auto& [nodes, boundary] = mesh.edges[i];
    const double r = std::max(mesh.nodes[nodes[0]][0], mesh.nodes[nodes[1]][0]);
    if (boundary == Boundary::axis && r != 0.)
      throw MeshError(fmt::format("{}: {} reaches r = {}, must be on r = 0 exactly", name, describe_edge(mesh, i), r));
    if (boundary != Boundary::axis && r == 0.)
      throw MeshError(fmt::format("{}: {} is on r = 0, must be axis", name, describe_edge(mesh, i)));
  }
}

void audit_contact_line(const Mesh& mesh, const std::string& name) {
  std::vector<std::pair<double, double>> intervals;
  for (std::size_t i = 0; i < mesh.edges.size(); ++i) {
    const auto& [nodes, boundary] = mesh.edges[i];
    if (boundary != Boundary::contact) continue;
    const auto& a = mesh.nodes[nodes[0]];
    const auto& b = mesh.nodes[nodes[1]];
    if (a[1] != 0. || b[1] != 0.)
      throw MeshError(fmt::format("{}: {} reaches z = {}, must be on z = 0 exactly", name, describe_edge(mesh, i),
                                  std::min(a[1], b[1])));
    intervals.push_back(std::minmax(a[0], b[0]));
  }
  std::sort(intervals.begin(), intervals.end());
  double end = 0.;
  for (const auto& [from, to] : intervals) {
    if (from != end)
      throw MeshError(
          fmt::format("{}: the contact line has no edge from r = {} to {}, must reach from r = 0 to its end "
                      "without gaps",
                      name, end, from));
    end = to;
  }
}

void audit_body(const Mesh& mesh, const std::string& name) {
  const auto walk = walk_boundary(mesh, name);
  if (walk.size() != mesh.edges.size())
    throw MeshError(
        fmt::format("{}: a walk around the boundary from {} takes {} of its {} edges, must be all: the body "
                    "is one part without holes",
                    name, describe_node(mesh, walk[0]), walk.size(), mesh.edges.size()));
  const double area = quality(mesh).area;
  const double area_inside = polygon_area(mesh, walk);
  if (std::abs(area - area_inside) > 1e-10 * area)
    throw MeshError(fmt::format("{}: the cells have an area of {}, must be that inside the boundary, {}: cells overlap",
                                name, area, area_inside));
}

}  // namespace fretval::meshes
