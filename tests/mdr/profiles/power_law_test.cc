#include "mdr/profiles/power_law.h"

#include <gtest/gtest.h>

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "mdr/profiles/profile.h"
#include "mdr/support/constants.h"

namespace fretval::mdr::power_law_test {
namespace {

// A few rounding errors of pow() and of the gamma function.
constexpr double roundoff = 1e-14;

const std::vector<double> exponents = {0.5, 1, 1.5, 2, 3.3, 7, 20};

TEST(TransformFactor, KnownValues) {
  EXPECT_NEAR(transform_factor(1), pi / 2, roundoff);
  EXPECT_NEAR(transform_factor(2), 2, roundoff);
  EXPECT_NEAR(transform_factor(3), 3 * pi / 4, roundoff);
  EXPECT_NEAR(transform_factor(4), 8.0 / 3, roundoff);
}

// Paper (3) with r = x sin(t), by a quadrature that knows nothing of gamma functions; its tolerance is 1e-14.
TEST(PowerLaw, TransformIsTheAbelIntegral) {
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

TEST(PowerLaw, BackTransformReturnsTheShape) {
  boost::math::quadrature::tanh_sinh<double> quadrature;
  for (const double n : exponents) {
    const Profile profile = power_law(0.7, n);
    const double r = 0.8;
    const double back = quadrature.integrate([&](double t) { return 2 / pi * transform(profile, r * std::sin(t)); },
                                             0.0, pi / 2, 1e-14);
    EXPECT_NEAR(back / shape(profile, r), 1, 1e-12) << "n = " << n;
  }
}

TEST(PowerLaw, InverseUndoesTheTransform) {
  for (const double n : exponents) {
    const Profile profile = power_law(3, n);
    for (const double x : {1e-9, 1e-3, 2.0}) {
      // d(x)/x = d(g)/(n g): roundoff of g is amplified by 1/n.
      EXPECT_NEAR(inverse_transform(profile, transform(profile, x)) / x, 1, roundoff * (1 + 1 / n));
    }
    EXPECT_EQ(inverse_transform(profile, 0), 0);
  }
}

TEST(PowerLaw, SlopesAreDerivatives) {
  for (const double n : exponents) {
    const Profile profile = power_law(3, n);
    const double h = 1e-5;
    const double slope = (transform(profile, 1 + h) - transform(profile, 1 - h)) / (2 * h);
    // Central difference: h^2 n^2 / 6 relative.
    EXPECT_NEAR(transform_slope(profile, 1) / slope, 1, h * h * n * n + 1e-10);
  }
}

// Parabola R = 1/2, cone of slope 1 and f = r^3, by hand: int_r^a g'/sqrt(x^2-r^2) dx with g = 2 x^2, pi/2 x, 3 pi/4
// x^3.
TEST(PowerLaw, SlopeIntegralsHaveTheirClosedForms) {
  const double r = 0.6, a = 1, root = 0.8;  // 0.6^2 + 0.8^2 = 1
  EXPECT_NEAR(abel_slope_integral(power_law(1, 2), r, a), 4 * root, roundoff);
  EXPECT_NEAR(abel_slope_integral(power_law(1, 1), r, a), pi / 2 * std::log((a + root) / r), roundoff);
  EXPECT_NEAR(abel_slope_integral(power_law(1, 3), r, a), 9 * pi / 8 * (a * root + r * r * std::log((a + root) / r)),
              10 * roundoff);
  for (const double n : exponents) EXPECT_EQ(abel_slope_integral(power_law(1, n), a, a), 0) << n;
}

// At r = 0: kappa_n b n a^(n-1)/(n-1), without bound for a tip that is not horizontal.
TEST(PowerLaw, SlopeIntegralOnTheAxisIsFiniteForAHorizontalTip) {
  EXPECT_TRUE(std::isinf(abel_slope_integral(power_law(1, 0.5), 0, 1)));
  EXPECT_TRUE(std::isinf(abel_slope_integral(power_law(1, 1), 0, 1)));
  EXPECT_NEAR(abel_slope_integral(power_law(1, 3), 0, 2), 3 * pi / 4 * 3 * 2 * 2 / 2, 100 * roundoff);
  EXPECT_NEAR(abel_slope_integral(power_law(1, 1.5), 1e-12, 1) / abel_slope_integral(power_law(1, 1.5), 0, 1), 1, 1e-5);
}

// Cone of slope 1: int x/sqrt(r^2-x^2) dx = sqrt(r^2-lower^2) - sqrt(r^2-upper^2), times pi/2.
TEST(PowerLaw, DepthIntegralsHaveTheirClosedForms) {
  EXPECT_NEAR(abel_depth_integral(power_law(1, 1), 0.28, 0.6, 1), pi / 2 * (0.96 - 0.8), roundoff);
  EXPECT_NEAR(abel_depth_integral(power_law(1, 1), 0.6, 0.96, 1), pi / 2 * (0.8 - 0.28), roundoff);
  // Parabola of R = 1/2 up to the far end: 2 (pi/4 r^2), the whole back transform.
  EXPECT_NEAR(abel_depth_integral(power_law(1, 2), 0, 3, 3), pi / 2 * 9, 100 * roundoff);
  EXPECT_EQ(abel_depth_integral(power_law(1, 2), 0.5, 0.5, 1), 0);
}

// One formula near the axis, another near r, a third for whole exponents: parts on either side of a joint make the
// whole.
TEST(PowerLaw, DepthIntegralsAddUp) {
  for (const double n : exponents) {
    const Profile profile = power_law(0.7, n);
    const double whole = abel_depth_integral(profile, 0, 1, 1);
    for (const double joint : {0.1, 0.7, 0.71, 0.95}) {
      const double sum = abel_depth_integral(profile, 0, joint, 1) + abel_depth_integral(profile, joint, 1, 1);
      EXPECT_NEAR(sum / whole, 1, 10 * roundoff) << n << " at " << joint;
    }
  }
}

TEST(PowerLaw, AreaUnderTheImageIsTheIntegral) {
  // int_0^2 2 x^2 dx, and of pi/2 x.
  EXPECT_NEAR(transform_integral(power_law(1, 2), 2), 16.0 / 3, 10 * roundoff);
  EXPECT_NEAR(transform_integral(power_law(1, 1), 2), pi, 10 * roundoff);
  EXPECT_THROW(transform_factor(0), std::invalid_argument);
}

}  // namespace
}  // namespace fretval::mdr::power_law_test
