#include "mdr/profiles/zone_depth.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mdr/profiles/profile_table.h"

namespace fretval::mdr::zone_depth_test {
namespace {

TEST(ZoneDepth, IsTheImageOutsideOfAFlatFace) {
  EXPECT_DOUBLE_EQ(zone_depth(parabola(2), 0.3), 0.09 / 2);
  EXPECT_DOUBLE_EQ(zone_radius(parabola(2), 0.09 / 2).value(), 0.3);
  EXPECT_FALSE(zone_radius(parabola(2), 0));
  EXPECT_FALSE(zone_radius(cone(0.1), -1e-9));
}

// A sphere of radius 1 cut down to a flat of 0.5: g = x sqrt(x^2 - b^2)/R, which is sqrt(3)/2 at 2 b = 1.
TEST(ZoneDepth, GoesOnBelowZeroWithinAFlatFace) {
  const Profile profile = truncated_sphere(1, 0.5);
  EXPECT_DOUBLE_EQ(zone_depth(profile, 1), std::sqrt(0.75));
  EXPECT_EQ(zone_depth(profile, 0.5), 0);
  EXPECT_DOUBLE_EQ(zone_depth(profile, 0.125), -0.75 * std::sqrt(0.75));
  for (const double c : {0.01, 0.2, 0.5, 0.7})
    EXPECT_NEAR(zone_radius(profile, zone_depth(profile, c)).value(), c, 1e-12);
  EXPECT_FALSE(zone_radius(profile, -std::sqrt(0.75)));
}

TEST(ZoneDepth, KnowsTheFlatFaceOfATable) {
  const Profile table = profile_table({0, 0.25, 0.5, 0.75, 0.9}, {0, 0, 0, 0.1, 0.25});
  EXPECT_LT(zone_depth(table, 0.25), 0);
  EXPECT_NEAR(zone_radius(table, zone_depth(table, 0.25)).value(), 0.25, 1e-12);
}

}  // namespace
}  // namespace fretval::mdr::zone_depth_test
