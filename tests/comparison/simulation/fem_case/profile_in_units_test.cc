#include "comparison/simulation/fem_case/profile_in_units.h"

#include <gtest/gtest.h>

#include <cmath>

#include "comparison/scene/scene.h"
#include "tests/comparison/suite_case.h"

namespace fretval::profile_in_units_test {
namespace {

TEST(ProfileInUnits, IsTheHeightOverTheDepth) {
  const auto input = suite_case("parabola-elastic-steady", 1e-2);
  const double R = input.indenter.radius, a = 1e-3, d = 1e-5;
  const auto profile = profile_in({a, d, 1, 1}, input.indenter, any_profile_of(input.indenter));
  EXPECT_DOUBLE_EQ(profile(0.5), 0.25 * a * a / (2 * R * d));
  const LimitingIndenter worn{1, 1, [](double r) { return 3 * r; }, 0};
  EXPECT_DOUBLE_EQ(profile_in({a, d, 1, 1}, worn)(2), 6 * a / d);
}

TEST(ProfileInUnits, IsHigherBeyondItsFarthestDepth) {
  auto input = suite_case("parabola-elastic-steady", 1e-2);
  input.indenter.shape = Case::Shape::sphere;
  const auto sphere = any_profile_of(input.indenter);
  const double R = input.indenter.radius, depth = 0.1 * R, radius = std::sqrt(depth * (2 * R - depth));
  EXPECT_NEAR(farthest_depth(input, sphere, depth), radius, 1e-4 * R);
  EXPECT_GE(farthest_depth(input, sphere, depth), radius);
  EXPECT_THROW(farthest_depth(input, sphere, 2 * R), InputError) << "all of it is in the body";
}

}  // namespace
}  // namespace fretval::profile_in_units_test
