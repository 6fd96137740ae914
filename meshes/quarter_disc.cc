#include "meshes/quarter_disc.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "meshes/audit.h"
#include "meshes/coarse_mesh.h"
#include "meshes/mesh_error.h"
#include "meshes/smoothing.h"
#include "meshes/split.h"

namespace fretval::meshes {
namespace {

void check(const QuarterDisc& disc) {
  const auto& nodes = disc.contact_nodes;
  if (nodes.size() < 2)
    throw MeshError(fmt::format("quarter disc: {} contact nodes, must be at least 2", nodes.size()));
  if (nodes[0] != 0.) throw MeshError(fmt::format("quarter disc: contact node 0 is at r = {}, must be 0", nodes[0]));
  for (std::size_t i = 1; i < nodes.size(); ++i)
    if (!(nodes[i] > nodes[i - 1]) || !std::isfinite(nodes[i]))
      throw MeshError(fmt::format("quarter disc: contact node {} is at r = {}, must be finite and larger than {}", i,
                                  nodes[i], nodes[i - 1]));
  if (!(disc.far_radius > nodes.back()) || !std::isfinite(disc.far_radius))
    throw MeshError(
        fmt::format("quarter disc: far radius is {}, must be finite and larger than the last contact node {}",
                    disc.far_radius, nodes.back()));
  if (!(disc.growth >= 0.02 && disc.growth <= 1.))
    throw MeshError(fmt::format("quarter disc: growth is {}, must be between 0.02 and 1", disc.growth));
}

/// The same disc with a contact line of length 1: gmsh has absolute tolerances.
QuarterDisc normalised(const QuarterDisc& disc) {
  QuarterDisc unit = disc;
  for (double& node : unit.contact_nodes) node /= disc.contact_nodes.back();
  unit.far_radius /= disc.contact_nodes.back();
  return unit;
}

/// Every second contact node; splitting the edges between them brings back the others. With an odd number of elements
/// the last edge reaches beyond the contact line, whose end becomes its middle.
std::vector<double> coarse_surface_nodes(const QuarterDisc& disc) {
  std::vector<double> nodes;
  for (std::size_t i = 0; i < disc.contact_nodes.size(); i += 2) nodes.push_back(disc.contact_nodes[i]);
  if (disc.contact_nodes.size() % 2 == 0) {
    const double end = disc.contact_nodes.back();
    const double last_size = end - disc.contact_nodes[disc.contact_nodes.size() - 2];
    nodes.push_back(end + std::min(last_size, (disc.far_radius - end) / 2.));
  }
  return nodes;
}

/// Under equal contact elements a row of squares, so that they also behave alike: the contact then errs smoothly with
/// the position of its edge. 0 for graded elements.
double strip_height(const QuarterDisc& disc) {
  const auto& nodes = disc.contact_nodes;
  const double first = nodes[1] - nodes[0];
  for (std::size_t i = 1; i < nodes.size(); ++i)
    if (std::abs(nodes[i] - nodes[i - 1] - first) > 1e-9 * first) return 0;
  return 2 * first;
}

/// Nodes of one side of the boundary, each once, sorted by r.
std::vector<unsigned> nodes_of_side(const SplitMesh& mesh, Side side) {
  std::vector<unsigned> nodes;
  for (const auto& edge : mesh.edges)
    if (edge.side == side) nodes.insert(nodes.end(), edge.nodes.begin(), edge.nodes.end());
  std::sort(nodes.begin(), nodes.end(), [&mesh](unsigned a, unsigned b) {
    return std::make_pair(mesh.nodes[a][0], a) < std::make_pair(mesh.nodes[b][0], b);
  });
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

/// Moves the nodes of the boundary from where gmsh and the splitting left them to where they belong, in real lengths.
void place_boundary(SplitMesh& mesh, const QuarterDisc& disc) {
  for (auto& node : mesh.nodes)
    for (double& x : node) x *= disc.contact_nodes.back();
  for (const unsigned node : nodes_of_side(mesh, Side::arc)) {
    auto& [r, z] = mesh.nodes[node];
    const double stretch = disc.far_radius / std::hypot(r, z);
    r *= stretch;
    z *= stretch;
  }
  for (const unsigned node : nodes_of_side(mesh, Side::axis)) mesh.nodes[node][0] = 0.;
  const auto surface = nodes_of_side(mesh, Side::surface);
  for (const unsigned node : surface) mesh.nodes[node][1] = 0.;
  if (surface.size() <= disc.contact_nodes.size())
    throw MeshError(
        fmt::format("mesh of the quarter disc: gmsh made {} nodes on the surface, must be more than the {} of "
                    "the contact line",
                    surface.size(), disc.contact_nodes.size()));
  for (std::size_t i = 0; i < disc.contact_nodes.size(); ++i) mesh.nodes[surface[i]][0] = disc.contact_nodes[i];
}

Boundary boundary_of(const CoarseMesh::Edge& edge, const SplitMesh& mesh, double contact_length) {
  if (edge.side == Side::axis) return Boundary::axis;
  if (edge.side == Side::arc) return Boundary::far;
  const double r_max = std::max(mesh.nodes[edge.nodes[0]][0], mesh.nodes[edge.nodes[1]][0]);
  return r_max <= contact_length ? Boundary::contact : Boundary::free;
}

}  // namespace

double element_size(const QuarterDisc& disc, double r, double z) {
  const auto& nodes = disc.contact_nodes;
  double smallest = std::numeric_limits<double>::max();
  // An element too far away to matter ends the search on its side: those beyond it are farther still.
  const auto consider = [&](std::size_t i) {
    const double along = std::max({nodes[i] - r, r - nodes[i + 1], 0.});
    const double by_distance = disc.growth * std::hypot(along, z);
    smallest = std::min(smallest, std::max(by_distance, nodes[i + 1] - nodes[i]));
    return by_distance < smallest;
  };
  const auto above = std::upper_bound(nodes.begin() + 1, nodes.end() - 1, r);
  const auto nearest = static_cast<std::size_t>(above - nodes.begin()) - 1;
  for (std::size_t i = nearest; i + 1 < nodes.size() && consider(i); ++i) continue;
  for (std::size_t i = nearest; i > 0 && consider(i - 1); --i) continue;
  return smallest;
}

Mesh quarter_disc(const QuarterDisc& disc) {
  check(disc);
  const QuarterDisc unit = normalised(disc);
  // Splitting halves the size.
  const auto size = [&unit](double r, double z) { return 2. * element_size(unit, r, z); };
  SplitMesh split_mesh = split(coarse_mesh(coarse_surface_nodes(unit), strip_height(unit), unit.far_radius, size));
  place_boundary(split_mesh, disc);

  Mesh mesh{split_mesh.nodes, split_mesh.cells, {}};
  for (const auto& edge : split_mesh.edges)
    mesh.edges.push_back({edge.nodes, boundary_of(edge, split_mesh, disc.contact_nodes.back())});
  smooth(mesh);
  audit(mesh, "mesh of the quarter disc");
  return mesh;
}

}  // namespace fretval::meshes
