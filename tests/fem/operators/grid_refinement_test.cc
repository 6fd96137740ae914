#include "fem/operators/grid_refinement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "tests/fem/half_space.h"

namespace fretval::fem::grid_refinement_test {
namespace {

GridData coarse_grid() {
  return quarter_disc_grid(1, 8, 6, 0.35);
}

double area(const GridData& grid, const std::array<unsigned, 4>& cell) {
  double twice = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto &a = grid.points[cell[k]], &b = grid.points[cell[(k + 1) % 4]];
    twice += a[0] * b[1] - b[0] * a[1];
  }
  return twice / 2;
}

/// Each edge of the cells, and how many cells share it.
std::map<std::set<unsigned>, int> edges_of(const GridData& grid) {
  std::map<std::set<unsigned>, int> edges;
  for (const auto& cell : grid.cells)
    for (std::size_t k = 0; k < 4; ++k) ++edges[{cell[k], cell[(k + 1) % 4]}];
  return edges;
}

std::map<BoundaryPart, double> lengths_of(const GridData& grid) {
  std::map<BoundaryPart, double> lengths;
  for (const auto& [points, part] : grid.boundary) {
    const auto &a = grid.points[points[0]], &b = grid.points[points[1]];
    lengths[part] += std::hypot(b[0] - a[0], b[1] - a[1]);
  }
  return lengths;
}

// One point more for each edge and cell, none twice. All cells counter-clockwise; straight edges: the same area.
TEST(GridRefinement, SplitsEachCellIntoFour) {
  const GridData coarse = coarse_grid(), fine = refined(coarse);
  ASSERT_EQ(fine.cells.size(), 4 * coarse.cells.size());
  EXPECT_EQ(fine.points.size(), coarse.points.size() + edges_of(coarse).size() + coarse.cells.size());
  for (std::size_t i = 0; i < coarse.cells.size(); ++i) {
    double sum = 0;
    for (std::size_t k = 4 * i; k < 4 * i + 4; ++k) {
      EXPECT_GT(area(fine, fine.cells[k]), 0);
      sum += area(fine, fine.cells[k]);
    }
    EXPECT_NEAR(sum, area(coarse, coarse.cells[i]), 1e-14) << i;
  }
}

// Edges of one cell alone are the boundary: neighbours share their midpoints.
TEST(GridRefinement, KeepsTheBoundaryAndItsParts) {
  const GridData coarse = coarse_grid(), fine = refined(coarse);
  EXPECT_EQ(fine.boundary.size(), 2 * coarse.boundary.size());
  const auto edges = edges_of(fine);
  for (const auto& edge : fine.boundary) EXPECT_EQ(edges.at({edge.points[0], edge.points[1]}), 1);
  const auto n_single = std::count_if(edges.begin(), edges.end(), [](const auto& edge) { return edge.second == 1; });
  EXPECT_EQ(static_cast<std::size_t>(n_single), fine.boundary.size());
  auto lengths = lengths_of(fine);
  for (const auto& [part, length] : lengths_of(coarse)) EXPECT_NEAR(lengths[part], length, 1e-13);
}

TEST(GridRefinement, KeepsTheElasticityOfEachCell) {
  GridData coarse = coarse_grid();
  coarse.elasticity.poisson_ratio = 0.3;
  for (std::size_t i = 0; i < coarse.cells.size(); ++i) coarse.elasticity.moduli.push_back(1 + static_cast<double>(i));
  const auto fine = refined(coarse);
  EXPECT_EQ(fine.elasticity.poisson_ratio, 0.3);
  ASSERT_EQ(fine.elasticity.moduli.size(), fine.cells.size());
  for (std::size_t k = 0; k < fine.cells.size(); ++k)
    EXPECT_EQ(fine.elasticity.moduli[k], coarse.elasticity.moduli[k / 4]) << k;
}

}  // namespace
}  // namespace fretval::fem::grid_refinement_test
