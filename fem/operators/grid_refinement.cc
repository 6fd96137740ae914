#include "fem/operators/grid_refinement.h"

#include <algorithm>
#include <map>
#include <utility>

namespace fretval::fem {

GridData refined(const GridData& grid) {
  GridData fine{grid.points, {}, {}, {grid.elasticity.poisson_ratio, {}}};
  std::map<std::pair<unsigned, unsigned>, unsigned> midpoints;
  const auto midpoint = [&](unsigned a, unsigned b) {
    const auto [place, is_new] = midpoints.emplace(std::minmax(a, b), static_cast<unsigned>(fine.points.size()));
    if (is_new)
      fine.points.push_back({(grid.points[a][0] + grid.points[b][0]) / 2, (grid.points[a][1] + grid.points[b][1]) / 2});
    return place->second;
  };
  for (const auto& cell : grid.cells) {
    const auto centre = static_cast<unsigned>(fine.points.size());
    fine.points.push_back({0, 0});
    for (const unsigned corner : cell)
      for (const std::size_t i : {0U, 1U}) fine.points[centre][i] += grid.points[corner][i] / 4;
    for (std::size_t k = 0; k < 4; ++k)
      fine.cells.push_back(
          {cell[k], midpoint(cell[k], cell[(k + 1) % 4]), centre, midpoint(cell[(k + 3) % 4], cell[k])});
  }
  for (const double modulus : grid.elasticity.moduli)
    fine.elasticity.moduli.insert(fine.elasticity.moduli.end(), 4, modulus);
  for (const auto& edge : grid.boundary) {
    const unsigned middle = midpoint(edge.points[0], edge.points[1]);
    fine.boundary.push_back({{edge.points[0], middle}, edge.part});
    fine.boundary.push_back({{middle, edge.points[1]}, edge.part});
  }
  return fine;
}

}  // namespace fretval::fem
