#include "fem/ring_contact/wider_rings.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "tests/fem/half_space.h"

namespace fretval::fem::wider_rings_test {
namespace {

TEST(WiderRings, MoveAsTheirTwoHalvesUnderTheSamePressure) {
  const auto& compliance = normal_half_space(16).compliance;  // 18 rings
  const auto wide = with_wider_rings(compliance);
  ASSERT_EQ(wide.areas.size(), 9);
  EXPECT_EQ(wide.radii, (std::vector<double>{0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1, 1.125}));
  Eigen::VectorXd pressure = Eigen::VectorXd::Zero(9), of_halves = Eigen::VectorXd::Zero(18);
  pressure[3] = of_halves[6] = of_halves[7] = 2;
  const Eigen::VectorXd moved = *wide.matrix * pressure, of_rings = *compliance.matrix * of_halves;
  for (Eigen::Index i = 0; i < 9; ++i) EXPECT_NEAR(moved[i], of_rings[2 * i] + of_rings[2 * i + 1], 1e-15);
  EXPECT_EQ(wide.half_space, nullptr);
}

TEST(WiderRings, AreThoseOfTheHalfSpaceToo) {
  auto compliance = normal_half_space(16).compliance;
  compliance.half_space = std::make_shared<const Compliance>(normal_half_space(16).compliance);
  const auto wide = with_wider_rings(compliance);
  ASSERT_TRUE(wide.half_space);
  EXPECT_EQ(wide.half_space->radii, wide.radii);
  EXPECT_EQ(*wide.half_space->matrix, *wide.matrix);
}

TEST(WiderRings, LeaveAnOddRingOut) {
  const Eigen::MatrixXd rows{{1, 2}, {3, 4}, {5, 6}};
  EXPECT_EQ(sums_of_pairs(rows), (Eigen::MatrixXd{{4, 6}}));
}

}  // namespace
}  // namespace fretval::fem::wider_rings_test
