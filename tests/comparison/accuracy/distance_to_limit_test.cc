#include "comparison/accuracy/distance_to_limit.h"

#include <gtest/gtest.h>

#include "mdr/profiles/profile.h"

namespace fretval {
namespace {

const mdr::LimitingProfile limit = mdr::limiting_profile(mdr::parabola(2), 1, 2);  // contact radius 2

double distance_of(double r, double f) {
  return distance_between({{r / 2, f / 2}}, chain_of(wear_limit(limit), 2, 3));
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
  ProfileChain points{{0, 0}, {0.25, mdr::shape(limit, 0.5) / 2}, {0.5, mdr::shape(limit, 1.0) / 2}};
  const auto chain = chain_of(wear_limit(limit), 2, 3);
  EXPECT_LT(distance_between(points, chain), 1e-6);
  points[0].y() = -0.1;
  EXPECT_NEAR(distance_between(points, chain), 0.1, 1e-6);
}

// Against a search through many points of all segments, of points all around a zigzag and beyond its ends.
TEST(DistanceToLimit, FindsTheNearestSegment) {
  const ProfileChain zigzag{{0, 0}, {1, 2}, {1, -1}, {1.5, 3}, {2, 0}, {3, 0.5}};
  for (double x = -1; x <= 4; x += 0.37)
    for (double y = -2; y <= 4; y += 0.41) {
      const Eigen::Vector2d p(x, y);
      double nearest = 100;
      for (std::size_t k = 1; k < zigzag.size(); ++k)
        for (int i = 0; i <= 2000; ++i)
          nearest = std::min(nearest, (p - zigzag[k - 1] - (zigzag[k] - zigzag[k - 1]) * i / 2000).norm());
      const double found = distance_between({p}, zigzag), spacing = 4.0 / 2000;
      EXPECT_LE(found, nearest + 1e-12) << x << " " << y;
      EXPECT_GE(found, nearest - spacing) << x << " " << y;
    }
}

}  // namespace
}  // namespace fretval
