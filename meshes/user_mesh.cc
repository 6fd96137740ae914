#include "meshes/user_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "meshes/audit.h"
#include "meshes/audit_cells.h"
#include "meshes/msh_sections.h"
#include "meshes/refined.h"

namespace fretval::meshes {
namespace {

using SortedEnds = std::pair<unsigned, unsigned>;
using Point = std::array<double, 2>;

constexpr double roundoff = 1e-9;  // of the size of the mesh, by which a drawn line may miss its place

SortedEnds sorted_ends(unsigned a, unsigned b) {
  return std::minmax(a, b);
}

/// The coordinates (r, z) of the nodes: x and y, or x and z of a section that was drawn upright.
std::vector<Point> section_nodes(const MshSections& sections, const std::string& file) {
  const auto is_zero = [&](std::size_t k) {
    return std::all_of(sections.nodes.begin(), sections.nodes.end(), [k](const auto& node) { return node[k] == 0.; });
  };
  if (!is_zero(1) && !is_zero(2)) {
    const auto out =
        std::find_if(sections.nodes.begin(), sections.nodes.end(), [](const auto& n) { return n[2] != 0.; });
    const auto number = sections.node_numbers[static_cast<std::size_t>(out - sections.nodes.begin())];
    throw MeshError(
        fmt::format("{}: node {} at ({}, {}, {}) is out of the plane, must be a section in the plane z = 0 (or y = 0), "
                    "with x for r",
                    file, number, (*out)[0], (*out)[1], (*out)[2]));
  }
  const std::size_t up = is_zero(2) ? 1 : 2;
  std::vector<Point> nodes;
  for (const auto& node : sections.nodes) nodes.push_back({node[0], node[up]});
  return nodes;
}

double twice_the_area(const std::vector<Point>& nodes, const std::vector<unsigned>& polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto &a = nodes[polygon[i]], &b = nodes[polygon[(i + 1) % polygon.size()]];
    twice += a[0] * b[1] - a[1] * b[0];
  }
  return twice;
}

/// Cells and their materials. Surfaces that are clockwise as a whole are turned; single cells are left for the audit.
MixedMesh cells_of(const MshSections& sections, const std::string& file) {
  MixedMesh mesh{section_nodes(sections, file), {}, {}, {}, {}};
  std::map<std::pair<long long, long long>, std::vector<std::size_t>> surfaces;
  for (const auto& element : sections.elements) {
    if (element.type != msh_triangle && element.type != msh_quadrilateral) continue;
    const auto name = group_name(sections, element);
    const auto found = std::find(mesh.materials.begin(), mesh.materials.end(), name);
    mesh.material.push_back(static_cast<unsigned>(found - mesh.materials.begin()));
    if (found == mesh.materials.end()) mesh.materials.push_back(name);
    surfaces[{element.group, element.entity}].push_back(mesh.polygons.size());
    mesh.polygons.push_back(element.nodes);
  }
  if (mesh.polygons.empty())
    throw MeshError(
        fmt::format("{}: has {} nodes, {} elements and no triangle or quadrilateral among them, must be a mesh of a "
                    "surface, the meridian section of the body",
                    file, sections.nodes.size(), sections.elements.size()));
  for (const auto& [surface, cells] : surfaces)
    if (std::all_of(cells.begin(), cells.end(),
                    [&](std::size_t i) { return twice_the_area(mesh.nodes, mesh.polygons[i]) < 0; }))
      for (const std::size_t i : cells) std::reverse(mesh.polygons[i].begin(), mesh.polygons[i].end());
  return mesh;
}

/// Number of cells that share an edge, and the edge in the sense of its first cell.
struct CellEdge {
  std::array<unsigned, 2> nodes;
  int n_cells;
};

std::map<SortedEnds, CellEdge> edges_of_cells(const MixedMesh& mesh) {
  std::map<SortedEnds, CellEdge> edges;
  for (const auto& polygon : mesh.polygons)
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const unsigned a = polygon[i], b = polygon[(i + 1) % polygon.size()];
      ++edges.try_emplace(sorted_ends(a, b), CellEdge{{a, b}, 0}).first->second.n_cells;
    }
  return edges;
}

constexpr std::array needed_groups{Boundary::contact, Boundary::axis, Boundary::base};

std::string quoted(const std::set<std::string>& names) {
  std::vector<std::string> in_quotes;
  for (const auto& name : names) in_quotes.push_back('"' + name + '"');
  return in_quotes.empty() ? "none" : fmt::format("{}", fmt::join(in_quotes, ", "));
}

/// Names of the curves that edges belong to.
std::map<SortedEnds, std::string> named_edges(const MshSections& sections, const std::string& file) {
  std::map<SortedEnds, std::string> names;
  std::set<std::string> found;
  const auto is_needed = [](const std::string& name) {
    return std::any_of(needed_groups.begin(), needed_groups.end(),
                       [&](Boundary boundary) { return boundary_name(boundary) == name; });
  };
  for (const auto& element : sections.elements) {
    if (element.type != msh_line) continue;
    const auto name = group_name(sections, element);
    if (name.empty()) continue;
    found.insert(name);
    auto& known = names[sorted_ends(element.nodes[0], element.nodes[1])];
    if (known != name && is_needed(known) && is_needed(name))
      throw MeshError(fmt::format("{}: line element {} is in the physical curves \"{}\" and \"{}\", must be in one",
                                  file, element.number, known, name));
    if (!is_needed(known)) known = name;
  }
  for (const Boundary boundary : needed_groups)
    if (const auto name = boundary_name(boundary); found.count(name) == 0)
      throw MeshError(
          fmt::format("{}: the physical curve \"{}\" has no elements, found are {}, must have \"contact\" (from r = 0 "
                      "on), \"axis\" (r = 0) and \"base\"; \"side\" and all others are free",
                      file, name, quoted(found)));
  if (found.count(boundary_name(Boundary::far)) > 0)
    throw MeshError(
        fmt::format("{}: the physical curve \"far\" cuts off a half-space, which a body on a \"base\" has not, must be "
                    "named \"side\" or \"free\" where it is free, \"base\" where it is held",
                    file));
  return names;
}

Boundary boundary_of(const std::string& name) {
  for (const Boundary boundary : needed_groups)
    if (boundary_name(boundary) == name) return boundary;
  return Boundary::free;
}

void add_boundary(const MshSections& sections, const std::string& file, MixedMesh& mesh) {
  const auto names = named_edges(sections, file);
  const auto edges = edges_of_cells(mesh);
  for (const auto& [ends, name] : names) {
    const auto found = edges.find(ends);
    const int n = found == edges.end() ? 0 : found->second.n_cells;
    if (boundary_of(name) != Boundary::free && n != 1)
      throw MeshError(fmt::format(
          "{}: the edge of the physical curve \"{}\" from ({}, {}) to ({}, {}) belongs to {} cells, must be 1", file,
          name, mesh.nodes[ends.first][0], mesh.nodes[ends.first][1], mesh.nodes[ends.second][0],
          mesh.nodes[ends.second][1], n));
  }
  for (const auto& [ends, edge] : edges) {
    if (edge.n_cells != 1) continue;
    const auto name = names.find(ends);
    mesh.edges.push_back({edge.nodes, name == names.end() ? Boundary::free : boundary_of(name->second)});
  }
}

void drop_unused_nodes(MixedMesh& mesh) {
  constexpr unsigned unused = std::numeric_limits<unsigned>::max();
  std::vector<unsigned> number(mesh.nodes.size(), unused);
  std::vector<Point> nodes;
  for (auto& polygon : mesh.polygons)
    for (unsigned& node : polygon) {
      if (number[node] == unused) {
        number[node] = static_cast<unsigned>(nodes.size());
        nodes.push_back(mesh.nodes[node]);
      }
      node = number[node];
    }
  for (auto& edge : mesh.edges)
    for (unsigned& node : edge.nodes) node = number[node];
  mesh.nodes = std::move(nodes);
}

/// The longer side of the box around the mesh.
double size_of(const std::vector<Point>& nodes) {
  Point low = nodes[0], high = nodes[0];
  for (const auto& node : nodes)
    for (const std::size_t k : {0U, 1U}) {
      low[k] = std::min(low[k], node[k]);
      high[k] = std::max(high[k], node[k]);
    }
  return std::max(high[0] - low[0], high[1] - low[1]);
}

/// Brings the contact surface to z = 0, and what misses a line by roundoff onto it.
void place(MixedMesh& mesh, const std::string& file) {
  for (const auto& node : mesh.nodes)
    if (!std::isfinite(node[0] + node[1]))
      throw MeshError(fmt::format("{}: a node is at ({}, {}), must have finite coordinates", file, node[0], node[1]));
  double low = std::numeric_limits<double>::infinity(), level = -low;
  for (const auto& edge : mesh.edges)
    if (edge.boundary == Boundary::contact)
      for (const unsigned node : edge.nodes) {
        low = std::min(low, mesh.nodes[node][1]);
        level = std::max(level, mesh.nodes[node][1]);
      }
  const double tolerance = roundoff * size_of(mesh.nodes);
  if (level - low > tolerance)
    throw MeshError(
        fmt::format("{}: the physical curve \"contact\" reaches from z = {} to {}, must be level", file, low, level));
  for (auto& [r, z] : mesh.nodes) {
    if (z - level > tolerance)
      throw MeshError(
          fmt::format("{}: the node at ({}, {}) lies above the contact surface, z = {}; must be on it or below: the "
                      "surface that the indenter touches is the top of the body",
                      file, r, z, level));
    z = std::abs(z - level) <= tolerance ? 0 : z - level;
    if (std::abs(r) <= tolerance) r = 0;
  }
}

/// Refuses a node in the middle of an edge of the boundary, which only one of the cells at the edge knows.
void require_no_hanging_nodes(const MixedMesh& mesh, const std::string& file) {
  std::set<unsigned> on_boundary;
  for (const auto& edge : mesh.edges) on_boundary.insert(edge.nodes.begin(), edge.nodes.end());
  for (const auto& edge : mesh.edges) {
    const auto &a = mesh.nodes[edge.nodes[0]], &b = mesh.nodes[edge.nodes[1]];
    const double along[]{b[0] - a[0], b[1] - a[1]}, length = std::hypot(along[0], along[1]);
    for (const unsigned i : on_boundary) {
      if (i == edge.nodes[0] || i == edge.nodes[1]) continue;
      const double from[]{mesh.nodes[i][0] - a[0], mesh.nodes[i][1] - a[1]};
      const double off = std::abs(along[0] * from[1] - along[1] * from[0]) / length,
                   at = (along[0] * from[0] + along[1] * from[1]) / length;
      if (off < roundoff * length && at > roundoff * length && at < (1 - roundoff) * length)
        throw MeshError(
            fmt::format("{}: the node at ({}, {}) hangs on the edge from ({}, {}) to ({}, {}), must be a corner of all "
                        "cells around it",
                        file, mesh.nodes[i][0], mesh.nodes[i][1], a[0], a[1], b[0], b[1]));
    }
  }
}

Mesh quadrilaterals_of(const MixedMesh& mixed) {
  if (std::any_of(mixed.polygons.begin(), mixed.polygons.end(), [](const auto& p) { return p.size() == 3; }))
    return split(mixed);
  Mesh mesh{mixed.nodes, {}, mixed.edges, mixed.materials, mixed.material};
  for (const auto& p : mixed.polygons) mesh.cells.push_back({p[0], p[1], p[2], p[3]});
  return mesh;
}

}  // namespace

Mesh read_user_mesh(const std::filesystem::path& path) {
  const auto file = path.string();
  const auto sections = read_sections(path);
  auto mixed = cells_of(sections, file);
  add_boundary(sections, file, mixed);
  drop_unused_nodes(mixed);
  place(mixed, file);
  require_no_hanging_nodes(mixed, file);
  auto mesh = quadrilaterals_of(mixed);
  audit(mesh, file);
  return mesh;
}

}  // namespace fretval::meshes
