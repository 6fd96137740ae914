#include "comparison/reference/half_space.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/comparison/suite_case.h"

namespace fretval::half_space_test {
namespace {

// At a/H = 0.1 the depth of a contact radius is 0.926 of Hertz's (an independent computation), so at a given depth a
// parabola has a radius larger by 1/sqrt(0.926), 3.9 %.
TEST(HalfSpaceLimit, IsWhereTheContactRadiusDepartsFromHertz) {
  const auto scene = suite_case("parabola-elastic-steady", 1e-2);
  const double a = std::sqrt(scene.indenter.radius * scene.motion.indentation), off = 1 / std::sqrt(0.926) - 1;
  EXPECT_NEAR(thickness_of_half_space(mdr_case(scene), 0.5, off) / a, 10 * (1 + off), 0.1);
}

TEST(HalfSpaceLimit, IsThinnerUnderAForceAndForACompressibleBody) {
  auto scene = suite_case("parabola-elastic-steady", 1e-2);
  const auto mdr = mdr_case(scene);
  const double incompressible = thickness_of_half_space(mdr, 0.5, 0.01);
  EXPECT_LT(thickness_of_half_space(mdr, 0.3, 0.01), incompressible);
  const double R = scene.indenter.radius, G = scene.elastomer.relaxed_modulus;
  scene.motion.normal_force = {16 * G / 3 * std::sqrt(R * std::pow(scene.motion.indentation, 3)), 0};
  EXPECT_LT(thickness_of_half_space(mdr_case(scene), 0.5, 0.01), 0.2 * incompressible);
}

// sqrt(R d) over a half-space, whatever the case stands on.
TEST(HalfSpaceAnswer, IsThatOfAHalfSpaceInThePlaceOfTheBody) {
  auto scene = suite_case("parabola-elastic-steady", 1e-2);
  scene.body = {Case::Body::Shape::layer, 1e-3, 0, true};
  const double a = std::sqrt(scene.indenter.radius * scene.motion.indentation);
  EXPECT_NEAR(half_space_answer(scene).contact_radius_max.value() / a, 1, 1e-12);
}

}  // namespace
}  // namespace fretval::half_space_test
