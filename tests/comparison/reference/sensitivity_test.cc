#include "comparison/reference/sensitivity.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/comparison/read_case.h"

namespace fretval {
namespace {

// c = sqrt(R (d0 - A)) of an elastic parabola with A = 2 u_x0 / (3 mu) alone: d ln c / d ln mu = A / (2 (d0 - A)).
TEST(Sensitivity, OfAnElasticParabolaIsThatOfTheClosedForm) {
  const auto found = sensitivities(read_case(replace(elastic_case(), "amplitude = 2e-5", "amplitude = 0")));
  ASSERT_TRUE(found && found->first_slip && found->shakedown);
  const double d0 = 1e-4, amplitude = 2 * 1.5e-5 / (3 * 0.5);
  for (const auto& one : {*found->first_slip, *found->shakedown}) {
    EXPECT_NEAR(one.friction, amplitude / (2 * (d0 - amplitude)), 1e-7);
    EXPECT_NEAR(one.relaxed_modulus, 0, 1e-9);
  }
}

// rho A in the place of A, with rho = sqrt(((G + x² (G + G1))² + (x G1)²)) / (G (1 + x²)), x = omega tau.
TEST(Sensitivity, OfAStiffBranchIsThatOfTheModulusRatio) {
  const auto found = sensitivities(read_case(replace(valid_case, "amplitude = 2e-5", "amplitude = 0")));
  ASSERT_TRUE(found && found->shakedown);
  const double pi = std::acos(-1.0), x = 2 * pi * 0.1, d0 = 1e-4, amplitude = 2 * 1.5e-5 / (3 * 0.5);
  const auto ratio = [&](double g) {
    const double branch = 1 / (1 + x * x);
    return std::hypot(g + x * x * branch, x * branch) / g;
  };
  const double h = 1e-5, slope = std::log(ratio(1 + h) / ratio(1 - h)) / std::log((1 + h) / (1 - h));
  const double a = ratio(1) * amplitude;
  EXPECT_NEAR(found->shakedown->relaxed_modulus, -slope * a / (2 * (d0 - a)), 1e-6);
  EXPECT_NEAR(found->shakedown->friction, a / (2 * (d0 - a)), 1e-6);
}

TEST(Sensitivity, IsNotKnownWhereNothingSticksOrWithoutAClosedForm) {
  const auto none = sensitivities(read_case(replace(valid_case, "amplitude = 1.5e-5", "amplitude = 1")));
  ASSERT_TRUE(none);
  EXPECT_FALSE(none->first_slip || none->shakedown);
  const auto forced = replace(valid_case, "Tangential amplitude = 1.5e-5", "Tangential force amplitude = 0.05");
  EXPECT_FALSE(sensitivities(read_case(forced)));
}

}  // namespace
}  // namespace fretval
