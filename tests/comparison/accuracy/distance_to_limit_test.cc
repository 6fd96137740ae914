#include "comparison/accuracy/distance_to_limit.h"

#include <gtest/gtest.h>

#include "mdr/profiles/profile.h"

namespace fretval {
namespace {

const mdr::LimitingProfile limit = mdr::limiting_profile(mdr::parabola(2), 1, 2);  // contact radius 2

double distance_of(double r, double f) {
  return distance_to_limit(limit, 2, Eigen::VectorXd::Constant(1, r), Eigen::VectorXd::Constant(1, f));
}

TEST(DistanceToLimit, IsNoneOnTheCurve) {
  for (const double r : {0.0, 0.5, 1.0, 1.001, 1.2, 2.0, limit.outer_radius, 3.0})
    EXPECT_LT(distance_of(r, mdr::shape(limit, r)), 1e-6) << r;
}

// In units of a = 2 along, and of d_max = 2 upwards.
TEST(DistanceToLimit, IsMeasuredInContactRadiusAndLargestIndentation) {
  EXPECT_NEAR(distance_of(0, -0.02), 0.01, 1e-9);  // below the apex, which is flat
  const double r = 1 + 1e-7;                       // next to the vertical part, in the middle of its rise
  EXPECT_NEAR(distance_of(r - 0.004, mdr::shape(limit, 1.0001)), 0.002, 5e-5);
  EXPECT_GT(mdr::shape(limit, 1.0001) - mdr::shape(limit, r - 0.004), 0.01) << "a large distance in height";
}

TEST(DistanceToLimit, IsTheLargestOfAllPoints) {
  Eigen::Vector3d r{0, 0.5, 1}, f{0, mdr::shape(limit, 0.5), mdr::shape(limit, 1.0)};
  EXPECT_LT(distance_to_limit(limit, 2, r, f), 1e-6);
  f[0] = -0.2;
  EXPECT_NEAR(distance_to_limit(limit, 2, r, f), 0.1, 1e-6);
}

}  // namespace
}  // namespace fretval
