#include "fem/ring_contact/stick_zone/stick_depths.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fretval::fem::stick_depths_test {
namespace {

TEST(StickDepths, CarryADepthToTheRadius) {
  const Eigen::VectorXd radii = Eigen::VectorXd::LinSpaced(10, 0.05, 0.95);
  const auto depths_of = [&](auto g) {
    StickDepths depths{Eigen::VectorXd(10), radii};
    for (Eigen::Index j = 0; j < 10; ++j) depths.depth[j] = 0.25 - g(radii[j]);
    return depths;
  };
  // A cone: the radius is as uncertain as the depth.
  const auto cone = depths_of([](double r) { return r; });
  EXPECT_NEAR(reach_of_edge(cone, 0.25, 0.01), 0.01, 1e-12);
  // Under a flat face of 0.6, deep by 1e-4: nothing or all of it.
  StickDepths flat = depths_of([](double r) { return r < 0.6 ? 0.2499 : 0.2499 + r - 0.6; });
  EXPECT_LT(reach_of_edge(flat, 0.6, 1e-5), 0.11);
  EXPECT_NEAR(reach_of_edge(flat, 0.6, 1e-3), 0.6, 1e-12);
  flat.depth.array() -= 2e-4;
  EXPECT_GT(reach_of_edge(flat, 0, 1e-3), 0.5);
  EXPECT_EQ(reach_of_edge(flat, 0, 1e-5), 0);
}

// A cone whose depth at the centre is small: rings end at 0.1 and 0.3.
TEST(StickDepths, TellWhetherASpotInsideTheFirstRingMayStick) {
  const auto cone = [](double at_centre) {
    return StickDepths{Eigen::Vector2d(at_centre - 0.1, at_centre - 0.3), Eigen::Vector2d(0.1, 0.3)};
  };
  EXPECT_FALSE(sticks_nowhere(cone(0.01))) << "a spot sticks";
  EXPECT_TRUE(sticks_nowhere(cone(-0.31)));
  EXPECT_FALSE(sticks_nowhere({Eigen::VectorXd::Constant(1, -1), Eigen::VectorXd::Constant(1, 0.1)}));
  for (const double n : {0.5, 1.0, 2.0, 8.0}) {  // something always sticks, up to the middle of the first ring
    const auto g = [n](double r) { return std::pow(r, n); };
    for (const double centre : {1e-3, 0.5, 0.999})
      EXPECT_FALSE(sticks_nowhere(
          {Eigen::Vector2d(centre * g(0.1) - g(0.1), centre * g(0.1) - g(0.3)), Eigen::Vector2d(0.1, 0.3)}))
          << n;
  }
}

TEST(StickDepths, ComeFromReservesAndSlip) {
  const Eigen::Vector3d reserve(0.3, 0.1, 0), slip(0, 0, 5);
  const auto depths = stick_depths({reserve, slip, 2}, Eigen::VectorXd::LinSpaced(5, 0.1, 0.9), 0.5, 2);
  EXPECT_TRUE(depths.depth.isApprox(Eigen::Vector3d(0.6, 0.2, -4)));
  EXPECT_EQ(depths.radius.size(), 3);
}

// By 0.4 between the last two rings that stick; slip has added up to 4 in the next one.
TEST(StickDepths, FallBeyondTheEdgeAsInside) {
  const StickDepths depths{Eigen::Vector4d(1, 0.6, 0.2, -4), Eigen::Vector4d(0, 1, 2, 3)};
  EXPECT_NEAR(width_of_edge(depths, 0.1), 2 * 0.1 / 0.4, 1e-15);
}

}  // namespace
}  // namespace fretval::fem::stick_depths_test
