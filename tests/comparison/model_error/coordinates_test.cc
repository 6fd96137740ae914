#include "comparison/model_error/coordinates.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/comparison/suite_case.h"

namespace fretval::coordinates_test {
namespace {

TEST(Coordinates, AreThoseOfClosedForms) {
  auto input = suite_case("parabola-elastic-steady", 1e-3);
  const auto& motion = input.motion;
  const double deepest = motion.indentation + motion.normal_amplitude, a = std::sqrt(input.indenter.radius * deepest);
  auto at = coordinates_of(input);
  EXPECT_NEAR(at.contact_radius, a, 1e-12);
  ASSERT_TRUE(at.shakedown && at.first_slip);
  EXPECT_LE(*at.first_slip, *at.shakedown);
  const double A = motion.tangential_amplitude * 2 / (3 * input.friction_coefficient), dd = motion.normal_amplitude,
               phase = *motion.phase * std::acos(-1.0) / 180;
  const double depth = motion.indentation - std::sqrt(A * A + dd * dd + 2 * A * dd * std::abs(std::cos(phase)));
  EXPECT_NEAR(*at.first_slip, std::sqrt(depth / deepest), 1e-9);
  EXPECT_EQ(at.radius_over_thickness, 0);
}

TEST(Coordinates, TurnAMotionByAMirror) {
  auto input = suite_case("parabola-elastic-steady", 1e-3);
  for (const double phase : {-150.0, 30.0, 210.0}) {
    input.motion.phase = phase;
    EXPECT_NEAR(coordinates_of(input).phase, 30, 1e-12);
  }
}

TEST(Coordinates, HaveTheContactRadiusOverALayer) {
  auto input = suite_case("parabola-elastic-steady", 1e-3);
  const double over_half_space = coordinates_of(input).contact_radius;
  input.body.shape = Case::Body::Shape::layer;
  input.body.thickness = 2e-3;
  input.contact = {true, true};
  const auto at = coordinates_of(input);
  EXPECT_GT(at.contact_radius, over_half_space);
  EXPECT_NEAR(at.radius_over_thickness, at.contact_radius / 2e-3, 1e-15);
}

}  // namespace
}  // namespace fretval::coordinates_test
