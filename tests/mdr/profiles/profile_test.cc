#include "mdr/profiles/profile.h"

#include <gtest/gtest.h>

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "mdr/support/constants.h"

namespace fretval::mdr::profile_test {
namespace {

const double nan = std::numeric_limits<double>::quiet_NaN();

// A few rounding errors of pow() and of the gamma function.
constexpr double roundoff = 1e-14;

const std::vector<double> exponents = {0.5, 1, 1.5, 2, 3.3, 7, 20};

TEST(TransformFactor, KnownValues) {
  EXPECT_NEAR(transform_factor(1), pi / 2, roundoff);
  EXPECT_NEAR(transform_factor(2), 2, roundoff);
  EXPECT_NEAR(transform_factor(3), 3 * pi / 4, roundoff);
  EXPECT_NEAR(transform_factor(4), 8.0 / 3, roundoff);
}

TEST(Profile, ParabolaAndConeHaveTheirClosedForms) {
  const Profile sphere = parabola(0.01);
  const Profile spike = cone(0.1);
  for (const double x : {0.0, 1e-6, 1e-3, 0.4}) {
    EXPECT_NEAR(shape(sphere, x), x * x / 0.02, roundoff * x * x / 0.01);
    EXPECT_NEAR(transform(sphere, x), x * x / 0.01, roundoff * x * x / 0.01);
    EXPECT_NEAR(transform(spike, -x), pi / 2 * x * std::tan(0.1), roundoff * x);
    EXPECT_NEAR(shape_slope(sphere, x), x / 0.01, roundoff * x / 0.01);
    EXPECT_NEAR(transform_slope(spike, x), pi / 2 * std::tan(0.1), roundoff);
  }
}

// Paper (3) with r = x sin(t), by a quadrature that knows nothing of gamma functions; its tolerance is 1e-14.
TEST(Profile, TransformIsTheAbelIntegral) {
  boost::math::quadrature::tanh_sinh<double> quadrature;
  for (const double n : exponents) {
    const Profile profile = power_law(0.7, n);
    const double x = 1.3;
    const double expected = quadrature.integrate(
        [&](double t) { return t > 0 ? x * shape_slope(profile, x * std::sin(t)) : 0.0; }, 0.0, pi / 2, 1e-14);
    // The singular slope of n < 1 costs the quadrature digits: sin(t)^(n-1) near t = 0.
    EXPECT_NEAR(transform(profile, x) / expected, 1, n < 1 ? 1e-9 : 1e-12) << "n = " << n;
  }
}

TEST(Profile, BackTransformReturnsTheShape) {
  boost::math::quadrature::tanh_sinh<double> quadrature;
  for (const double n : exponents) {
    const Profile profile = power_law(0.7, n);
    const double r = 0.8;
    const double back = quadrature.integrate([&](double t) { return 2 / pi * transform(profile, r * std::sin(t)); },
                                             0.0, pi / 2, 1e-14);
    EXPECT_NEAR(back / shape(profile, r), 1, 1e-12) << "n = " << n;
  }
}

TEST(Profile, InverseUndoesTheTransform) {
  for (const double n : exponents) {
    const Profile profile = power_law(3, n);
    for (const double x : {1e-9, 1e-3, 2.0}) {
      // d(x)/x = d(g)/(n g): roundoff of g is amplified by 1/n.
      EXPECT_NEAR(inverse_transform(profile, transform(profile, x)) / x, 1, roundoff * (1 + 1 / n));
    }
    EXPECT_EQ(inverse_transform(profile, 0), 0);
  }
}

TEST(Profile, SlopesAreDerivatives) {
  for (const double n : exponents) {
    const Profile profile = power_law(3, n);
    const double h = 1e-5;
    const double slope = (transform(profile, 1 + h) - transform(profile, 1 - h)) / (2 * h);
    // Central difference: h^2 n^2 / 6 relative.
    EXPECT_NEAR(transform_slope(profile, 1) / slope, 1, h * h * n * n + 1e-10);
  }
}

TEST(Profile, RejectsBadArguments) {
  EXPECT_THROW(parabola(0), std::invalid_argument);
  EXPECT_THROW(parabola(-1), std::invalid_argument);
  EXPECT_THROW(parabola(nan), std::invalid_argument);
  EXPECT_THROW(cone(0), std::invalid_argument);
  EXPECT_THROW(cone(pi / 2), std::invalid_argument);
  EXPECT_THROW(cone(nan), std::invalid_argument);
  EXPECT_THROW(power_law(1, 0.4), std::invalid_argument);
  EXPECT_THROW(power_law(1, 21), std::invalid_argument);
  EXPECT_THROW(power_law(0, 2), std::invalid_argument);
  EXPECT_THROW(shape(parabola(1), -1), std::invalid_argument);
  EXPECT_THROW(transform(parabola(1), nan), std::invalid_argument);
  EXPECT_THROW(inverse_transform(parabola(1), -1e-9), std::invalid_argument);
}

TEST(Profile, MessageNamesQuantityValueAndRange) {
  try {
    power_law(1, 21);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "exponent of the power law = 21: must lie between 0.5 and 20");
  }
}

}  // namespace
}  // namespace fretval::mdr::profile_test
