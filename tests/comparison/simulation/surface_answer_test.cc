#include "comparison/simulation/surface_answer.h"

#include <gtest/gtest.h>

namespace fretval {
namespace {

// Motion along x leaves a quarter of the angles: those behind the mirrors have the edges of their images.
TEST(SurfaceAnswer, HasItsEdgesAroundTheWholeCircle) {
  SurfaceAnswer surface;
  surface.grid = fem::angular_grid(8, fem::Mirrors::x_and_y);
  const auto n = static_cast<std::size_t>(surface.grid.n_kept());
  ASSERT_GT(n, 1U);
  for (std::size_t j = 0; j < n; ++j) surface.contact.edges.push_back(1 + static_cast<double>(j));
  surface.never_slipped.edges = std::vector<double>(n, 0.25);
  surface.sticks_in_a_cycle.edges = std::vector<double>(n, 0.5);
  const auto edges = edges_of(surface);
  ASSERT_EQ(edges.angle.size(), 8U);
  EXPECT_EQ(edges.contact.front(), 1);
  EXPECT_EQ(edges.contact[4], 1) << "opposite";
  EXPECT_EQ(edges.contact[2], static_cast<double>(n)) << "across";
  EXPECT_EQ(edges.never_slipped, std::vector<double>(8, 0.25));
  EXPECT_EQ(edges.sticks_in_a_cycle, std::vector<double>(8, 0.5));
}

}  // namespace
}  // namespace fretval
