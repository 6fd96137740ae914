#include "meshes/smoothing.h"

#include <algorithm>

#include "meshes/quality.h"

namespace fretval::meshes {
namespace {

using CellsOfNode = std::vector<std::vector<std::size_t>>;

CellsOfNode cells_of_inner_nodes(const Mesh& mesh) {
  CellsOfNode cells(mesh.nodes.size());
  for (std::size_t i = 0; i < mesh.cells.size(); ++i)
    for (const unsigned node : mesh.cells[i]) cells[node].push_back(i);
  for (const auto& edge : mesh.edges)
    for (const unsigned node : edge.nodes) cells[node].clear();
  return cells;
}

double poorest(const Mesh& mesh, const std::vector<std::size_t>& cells) {
  double jacobian = 1.;
  for (const std::size_t cell : cells) jacobian = std::min(jacobian, scaled_jacobian(mesh, mesh.cells[cell]));
  return jacobian;
}

/// Mean of the nodes that share an edge with an inner node; each is met in two cells.
std::array<double, 2> mean_of_neighbours(const Mesh& mesh, unsigned node, const std::vector<std::size_t>& cells) {
  std::array<double, 2> mean{0., 0.};
  for (const std::size_t c : cells) {
    const auto& cell = mesh.cells[c];
    const auto corner = std::find(cell.begin(), cell.end(), node) - cell.begin();
    for (const auto neighbour : {cell[(corner + 1) % 4], cell[(corner + 3) % 4]})
      for (const int i : {0, 1}) mean[i] += mesh.nodes[neighbour][i] / (2. * static_cast<double>(cells.size()));
  }
  return mean;
}

void move_if_better(Mesh& mesh, unsigned node, const std::vector<std::size_t>& cells) {
  const auto target = mean_of_neighbours(mesh, node, cells);
  for (const double step : {1., 0.5, 0.25}) {
    const double before = poorest(mesh, cells);
    const auto old = mesh.nodes[node];
    for (const int i : {0, 1}) mesh.nodes[node][i] += step * (target[i] - old[i]);
    if (poorest(mesh, cells) > before) return;
    mesh.nodes[node] = old;
  }
}

}  // namespace

void smooth(Mesh& mesh) {
  constexpr double poor = 0.4;
  constexpr int n_sweeps = 10;
  const auto cells_of_node = cells_of_inner_nodes(mesh);
  for (int sweep = 0; sweep < n_sweeps; ++sweep)
    for (const auto& cell : mesh.cells)
      if (scaled_jacobian(mesh, cell) < poor)
        for (const unsigned node : cell) move_if_better(mesh, node, cells_of_node[node]);
}

}  // namespace fretval::meshes
