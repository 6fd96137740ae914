#include "meshes/body_mesh.h"

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

void check(const BodySection& section, const std::string& name) {
  const auto& [nodes, outline, growth] = section;
  if (nodes.size() < 2) throw MeshError(fmt::format("{}: {} contact nodes, must be at least 2", name, nodes.size()));
  if (nodes[0] != 0.) throw MeshError(fmt::format("{}: contact node 0 is at r = {}, must be 0", name, nodes[0]));
  for (std::size_t i = 1; i < nodes.size(); ++i)
    if (!(nodes[i] > nodes[i - 1]) || !std::isfinite(nodes[i]))
      throw MeshError(fmt::format("{}: contact node {} is at r = {}, must be finite and larger than {}", name, i,
                                  nodes[i], nodes[i - 1]));
  if (!(outline.radius > nodes.back()) || !std::isfinite(outline.radius))
    throw MeshError(fmt::format("{}: {}radius is {}, must be finite and larger than the last contact node {}", name,
                                outline.thickness ? "" : "far ", outline.radius, nodes.back()));
  if (const double thickness = outline.thickness.value_or(1); !(thickness > 0) || !std::isfinite(thickness))
    throw MeshError(fmt::format("{}: thickness is {}, must be finite and positive", name, thickness));
  if (!(growth >= 0.02 && growth <= 1.))
    throw MeshError(fmt::format("{}: growth is {}, must be between 0.02 and 1", name, growth));
}

/// The section scaled to a contact line of length 1: gmsh has absolute tolerances.
BodySection normalised(const BodySection& section) {
  BodySection unit = section;
  const double length = section.contact_nodes.back();
  for (double& node : unit.contact_nodes) node /= length;
  unit.outline.radius /= length;
  if (unit.outline.thickness) *unit.outline.thickness /= length;
  return unit;
}

/// Every second contact node; splitting the edges between them brings back the others. With an odd number of elements
/// the last edge reaches beyond the contact line, whose end becomes its middle.
std::vector<double> coarse_surface_nodes(const BodySection& section) {
  const auto& contact = section.contact_nodes;
  std::vector<double> nodes;
  for (std::size_t i = 0; i < contact.size(); i += 2) nodes.push_back(contact[i]);
  if (contact.size() % 2 == 0) {
    const double end = contact.back();
    const double last_size = end - contact[contact.size() - 2];
    nodes.push_back(end + std::min(last_size, (section.outline.radius - end) / 2.));
  }
  return nodes;
}

/// Height of a row of squares under contact elements of equal size, which behave alike thereby: the error of the
/// contact then varies smoothly with the position of its edge. 0: no such row, under graded elements and in a body that
/// the row would nearly fill.
double strip_height(const BodySection& section) {
  constexpr double largest_part = 0.7;  // of the thickness, so that the cells below are not flat
  const auto& nodes = section.contact_nodes;
  const double first = nodes[1] - nodes[0];
  for (std::size_t i = 1; i < nodes.size(); ++i)
    if (std::abs(nodes[i] - nodes[i - 1] - first) > 1e-9 * first) return 0;
  const bool fits = !section.outline.thickness || 2 * first <= largest_part * *section.outline.thickness;
  return fits ? 2 * first : 0;
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
void place_boundary(SplitMesh& mesh, const BodySection& section, const std::string& name) {
  const auto& [contact_nodes, outline, growth] = section;
  for (auto& node : mesh.nodes)
    for (double& x : node) x *= contact_nodes.back();
  for (const unsigned node : nodes_of_side(mesh, Side::arc)) {
    auto& [r, z] = mesh.nodes[node];
    const double stretch = outline.radius / std::hypot(r, z);
    r *= stretch;
    z *= stretch;
  }
  for (const unsigned node : nodes_of_side(mesh, Side::side)) mesh.nodes[node][0] = outline.radius;
  for (const unsigned node : nodes_of_side(mesh, Side::base)) mesh.nodes[node][1] = -outline.thickness.value();
  for (const unsigned node : nodes_of_side(mesh, Side::axis)) mesh.nodes[node][0] = 0.;
  const auto surface = nodes_of_side(mesh, Side::surface);
  for (const unsigned node : surface) mesh.nodes[node][1] = 0.;
  if (surface.size() <= contact_nodes.size())
    throw MeshError(fmt::format("{}: gmsh made {} nodes on the surface, must be more than the {} of the contact line",
                                name, surface.size(), contact_nodes.size()));
  for (std::size_t i = 0; i < contact_nodes.size(); ++i) mesh.nodes[surface[i]][0] = contact_nodes[i];
}

Boundary boundary_of(const CoarseMesh::Edge& edge, const SplitMesh& mesh, double contact_length) {
  if (edge.side == Side::axis) return Boundary::axis;
  if (edge.side == Side::arc) return Boundary::far;
  if (edge.side == Side::base) return Boundary::base;
  if (edge.side == Side::side) return Boundary::free;
  const double r_max = std::max(mesh.nodes[edge.nodes[0]][0], mesh.nodes[edge.nodes[1]][0]);
  return r_max <= contact_length ? Boundary::contact : Boundary::free;
}

}  // namespace

double element_size(const std::vector<double>& nodes, double growth, double r, double z) {
  double smallest = std::numeric_limits<double>::max();
  // An element too far away to matter ends the search on its side: those beyond it are farther still.
  const auto consider = [&](std::size_t i) {
    const double along = std::max({nodes[i] - r, r - nodes[i + 1], 0.});
    const double by_distance = growth * std::hypot(along, z);
    smallest = std::min(smallest, std::max(by_distance, nodes[i + 1] - nodes[i]));
    return by_distance < smallest;
  };
  const auto above = std::upper_bound(nodes.begin() + 1, nodes.end() - 1, r);
  const auto nearest = static_cast<std::size_t>(above - nodes.begin()) - 1;
  for (std::size_t i = nearest; i + 1 < nodes.size() && consider(i); ++i) continue;
  for (std::size_t i = nearest; i > 0 && consider(i - 1); --i) continue;
  return smallest;
}

Mesh body_mesh(const BodySection& section, const std::string& name) {
  check(section, name);
  const BodySection unit = normalised(section);
  const double largest = unit.outline.thickness ? *unit.outline.thickness : std::numeric_limits<double>::infinity();
  // Splitting halves the size.
  const auto size = [&](double r, double z) {
    return std::min(2. * element_size(unit.contact_nodes, unit.growth, r, z), largest);
  };
  SplitMesh split_mesh = split(coarse_mesh(coarse_surface_nodes(unit), strip_height(unit), unit.outline, size));
  place_boundary(split_mesh, section, "mesh of the " + name);

  Mesh mesh{split_mesh.nodes, split_mesh.cells, {}};
  for (const auto& edge : split_mesh.edges)
    mesh.edges.push_back({edge.nodes, boundary_of(edge, split_mesh, section.contact_nodes.back())});
  smooth(mesh);
  audit(mesh, "mesh of the " + name);
  return mesh;
}

}  // namespace fretval::meshes
