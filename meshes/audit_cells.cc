#include "meshes/audit_cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "meshes/mesh_error.h"
#include "meshes/quality.h"

namespace fretval::meshes {
namespace {

std::string describe_cell(const Mesh& mesh, std::size_t cell) {
  double r = 0.;
  double z = 0.;
  for (const unsigned node : mesh.cells[cell]) {
    r += mesh.nodes[node][0] / 4.;
    z += mesh.nodes[node][1] / 4.;
  }
  return fmt::format("cell {} around ({}, {})", cell, r, z);
}

template <std::size_t n>
void check_indices(const std::array<unsigned, n>& nodes, const std::string& entity, std::size_t n_nodes,
                   const std::string& name) {
  for (const unsigned node : nodes)
    if (node >= n_nodes)
      throw MeshError(
          fmt::format("{}: {} has node {}, must be below the number of nodes {}", name, entity, node, n_nodes));
}

/// Text on what is wrong with a cell whose Jacobian is too small.
std::string defect(const Mesh& mesh, const std::array<unsigned, 4>& cell, double tolerance) {
  const double jacobian = scaled_jacobian(mesh, cell);
  const double reversed = scaled_jacobian(mesh, {cell[3], cell[2], cell[1], cell[0]});
  if (reversed >= tolerance) return "inverted (clockwise)";
  if (jacobian > -tolerance || std::isnan(jacobian)) return "collapsed";
  return "a bow-tie or not convex";
}

void check_not_twice(const Mesh& mesh, const std::string& name) {
  std::map<std::array<unsigned, 4>, std::size_t> known;
  for (std::size_t i = 0; i < mesh.cells.size(); ++i) {
    auto nodes = mesh.cells[i];
    std::sort(nodes.begin(), nodes.end());
    const auto [first, is_new] = known.emplace(nodes, i);
    if (!is_new)
      throw MeshError(fmt::format("{}: {} has the nodes {} of cell {}, must have its own", name, describe_cell(mesh, i),
                                  fmt::join(nodes, ", "), first->second));
  }
}

void check_used(const Mesh& mesh, const std::string& name) {
  std::vector<bool> used(mesh.nodes.size(), false);
  for (const auto& cell : mesh.cells)
    for (const unsigned node : cell) used[node] = true;
  const auto unused = std::find(used.begin(), used.end(), false);
  if (unused != used.end())
    throw MeshError(fmt::format("{}: {} is used by 0 cells, must be at least 1", name,
                                describe_node(mesh, static_cast<unsigned>(unused - used.begin()))));
}

void check_distinct(const Mesh& mesh, const std::string& name) {
  const double tolerance = 1e-6 * quality(mesh).smallest_edge;
  std::vector<unsigned> order(mesh.nodes.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&mesh](unsigned a, unsigned b) { return mesh.nodes[a] < mesh.nodes[b]; });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto& a = mesh.nodes[order[i]];
    for (std::size_t j = i + 1; j < order.size() && mesh.nodes[order[j]][0] - a[0] <= tolerance; ++j) {
      const auto& b = mesh.nodes[order[j]];
      const double distance = std::hypot(b[0] - a[0], b[1] - a[1]);
      if (distance > tolerance) continue;
      const auto [first, second] = std::minmax(order[i], order[j]);
      throw MeshError(fmt::format("{}: {} is at a distance of {} from node {}, must be more than {}", name,
                                  describe_node(mesh, second), distance, first, tolerance));
    }
  }
}

}  // namespace

std::string describe_node(const Mesh& mesh, unsigned node) {
  return fmt::format("node {} at ({}, {})", node, mesh.nodes[node][0], mesh.nodes[node][1]);
}

void audit_indices(const Mesh& mesh, const std::string& name) {
  if (mesh.cells.empty()) throw MeshError(fmt::format("{}: the mesh has 0 cells, must have at least 1", name));
  for (std::size_t i = 0; i < mesh.cells.size(); ++i)
    check_indices(mesh.cells[i], fmt::format("cell {}", i), mesh.nodes.size(), name);
  for (std::size_t i = 0; i < mesh.edges.size(); ++i)
    check_indices(mesh.edges[i].nodes, fmt::format("edge {}", i), mesh.nodes.size(), name);
}

void audit_nodes(const Mesh& mesh, const std::string& name) {
  for (unsigned i = 0; i < mesh.nodes.size(); ++i) {
    const auto [r, z] = mesh.nodes[i];
    if (!std::isfinite(r) || !std::isfinite(z))
      throw MeshError(fmt::format("{}: {} must have finite coordinates", name, describe_node(mesh, i)));
    if (r < 0.) throw MeshError(fmt::format("{}: {} has r = {}, must be at least 0", name, describe_node(mesh, i), r));
    if (z > 0.) throw MeshError(fmt::format("{}: {} has z = {}, must be at most 0", name, describe_node(mesh, i), z));
  }
}

void audit_cells(const Mesh& mesh, const std::string& name) {
  constexpr double tolerance = 1e-8;
  for (std::size_t i = 0; i < mesh.cells.size(); ++i) {
    const double jacobian = scaled_jacobian(mesh, mesh.cells[i]);
    // Not "< tolerance", which NaN would pass.
    if (!(jacobian >= tolerance))
      throw MeshError(fmt::format("{}: {} is {}: smallest scaled corner Jacobian {}, must be positive", name,
                                  describe_cell(mesh, i), defect(mesh, mesh.cells[i], tolerance), jacobian));
  }
  check_not_twice(mesh, name);
}

void audit_node_use(const Mesh& mesh, const std::string& name) {
  check_used(mesh, name);
  check_distinct(mesh, name);
}

}  // namespace fretval::meshes
