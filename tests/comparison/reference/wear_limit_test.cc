#include "comparison/reference/wear_limit.h"

#include <gtest/gtest.h>

namespace fretval {
namespace {

TEST(WearLimit, OfAThickLayerIsThatOfTheHalfSpace) {
  const auto profile = mdr::parabola(1e-2);
  const auto half_space = wear_limit(mdr::limiting_profile(profile, 6e-4, 1e-4)),
             layer = wear_limit(mdr::layer_limiting_profile(profile, {1e3, 0.5}, 6e-4, 1e-4));
  EXPECT_EQ(half_space.stick_radius, 6e-4);
  EXPECT_NEAR(layer.outer_radius / half_space.outer_radius, 1, 1e-5);
  EXPECT_NEAR(layer.volume / half_space.volume, 1, 1e-4);
  for (const double r : {3e-4, 7e-4, 9e-4, 1.1e-3, 2e-3})
    EXPECT_NEAR(layer.height(r) / half_space.height(r), 1, 1e-4) << r;
}

// Volumes by shells of the heights, which are vertical at the stick radius.
TEST(WearLimit, HasTheVolumeOfItsHeights) {
  const auto profile = mdr::parabola(1e-2);
  const double c = 6e-4, pi = 3.14159265358979323846;
  for (const auto& limit : {wear_limit(mdr::limiting_profile(profile, c, 1e-4)),
                            wear_limit(mdr::layer_limiting_profile(profile, {5e-4, 0.45}, c, 1e-4))}) {
    constexpr int n = 4000;
    double volume = 0;
    const double width = limit.outer_radius - c;
    for (int i = 0; i < n; ++i) {
      const double s = (i + 0.5) / n, r = c + width * s * s;
      volume += 2 * pi * r * (limit.height(r) - r * r / 2e-2) * 2 * width * s / n;
    }
    EXPECT_NEAR(volume / limit.volume, 1, 1e-5);
  }
}

}  // namespace
}  // namespace fretval
