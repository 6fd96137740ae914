#include "fem/condensation/merged_rings.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace fretval::fem {
namespace {

Compliance three_rings() {
  Eigen::MatrixXd matrix(3, 3);
  matrix << 4, 1, 0.5, 1, 3, 0.7, 0.5, 0.7, 2;
  return {{0, 1, 2, 4}, Eigen::Vector3d(1, 3, 12), SharedMatrix(matrix)};
}

// A traction on a wide ring is the same one on its parts, and its displacement the integral over both.
TEST(MergedRings, CarryWhatTheirPartsDoTogether) {
  const auto merged = merged_rings(three_rings(), {0, 2, 4});
  EXPECT_EQ(merged.radii, (std::vector<double>{0, 2, 4}));
  EXPECT_EQ(merged.areas, Eigen::Vector2d(4, 12));
  EXPECT_EQ((*merged.matrix)(0, 0), 4 + 3 + 2 * 1);
  EXPECT_DOUBLE_EQ((*merged.matrix)(0, 1), 0.5 + 0.7);
  EXPECT_EQ((*merged.matrix)(1, 1), 2);
  EXPECT_FALSE(merged.half_space);
}

TEST(MergedRings, OfSeveralComponentsAreMergedInEach) {
  auto two = three_rings();
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(6, 6);
  matrix.topLeftCorner(3, 3) = *two.matrix;
  matrix.bottomRightCorner(3, 3) = 2 * *two.matrix;
  matrix(0, 4) = matrix(4, 0) = 0.25;
  two.matrix = SharedMatrix(matrix);
  const auto one = merged_rings(three_rings(), {0, 2, 4}), merged = merged_rings(two, {0, 2, 4});
  EXPECT_EQ(merged.areas, one.areas);
  EXPECT_EQ(merged.matrix->topLeftCorner(2, 2), *one.matrix);
  EXPECT_EQ(merged.matrix->bottomRightCorner(2, 2), 2 * *one.matrix);
  EXPECT_EQ((*merged.matrix)(0, 2), 0.25);
}

TEST(MergedRings, OfAllAreTheSame) {
  const auto merged = merged_rings(three_rings(), three_rings().radii);
  EXPECT_EQ(*merged.matrix, *three_rings().matrix);
}

TEST(MergedRings, MergeThoseOfTheHalfSpaceToo) {
  auto compliance = three_rings();
  compliance.half_space = std::make_shared<const Compliance>(three_rings());
  const auto merged = merged_rings(compliance, {0, 1, 4});
  ASSERT_TRUE(merged.half_space);
  EXPECT_EQ(merged.half_space->radii, (std::vector<double>{0, 1, 4}));
}

TEST(MergedRings, HaveRadiiOfTheRings) {
  for (const auto& radii : {std::vector<double>{0, 1.5, 4}, {1, 4}, {0}, {0, 5}})
    EXPECT_THROW(merged_rings(three_rings(), radii), std::invalid_argument);
}

}  // namespace
}  // namespace fretval::fem
