#include "mdr/stick/limiting_profile.h"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "mdr/profiles/indentation.h"
#include "mdr/support/constants.h"

namespace fretval::mdr::limiting_profile_test {
namespace {

const double nan = std::numeric_limits<double>::quiet_NaN();

double outer_ratio(const Profile& unworn, double stick_ratio) {
  const double a0 = inverse_transform(unworn, 0.2);
  return limiting_profile(unworn, stick_ratio * a0, 0.2).outer_radius / a0;
}

// Four decimals of an independent ring-load computation: half a unit in the last place. The last value of the cone is
// the closed form's below, 1.05075, cut to four decimals; the ring loads gave 1.0508.
TEST(LimitingProfile, OuterRadius) {
  const std::vector<double> stick_ratios = {0.1, 0.5, 0.7, 0.9};
  const std::vector<double> of_parabola = {1.3813, 1.2298, 1.1429, 1.0492};
  const std::vector<double> of_cone = {1.5077, 1.2683, 1.1567, 1.0507};
  for (std::size_t i = 0; i < stick_ratios.size(); ++i) {
    EXPECT_NEAR(outer_ratio(parabola(5), stick_ratios[i]), of_parabola[i], 5e-5);
    EXPECT_NEAR(outer_ratio(cone(0.3), stick_ratios[i]), of_cone[i], 5e-5);
  }
}

// Where the closed forms of f_inf and f0 meet, with lengths in a0: cone sqrt(r^2-c^2) = arccos(c/r), parabola
// r^2 arccos(c/r) + c sqrt(r^2-c^2) = 2 arccos(c/r). An error of roundoff in these is amplified by 1/(1-c).
TEST(LimitingProfile, OuterRadiusSolvesTheClosedForms) {
  for (const double c : {0.1, 0.5, 0.7, 0.9}) {
    const double r = outer_ratio(cone(0.3), c);
    EXPECT_NEAR(std::sqrt(r * r - c * c), std::acos(c / r), 1e-13);
    const double q = outer_ratio(parabola(5), c);
    EXPECT_NEAR(q * q * std::acos(c / q) + c * std::sqrt(q * q - c * c), 2 * std::acos(c / q), 1e-13);
  }
}

TEST(LimitingProfile, OuterRadiusAtItsLimits) {
  EXPECT_NEAR(outer_ratio(parabola(5), 1), 1, 1e-15);
  EXPECT_NEAR(outer_ratio(cone(0.3), 1), 1, 1e-15);
  // For small c the parabola's a_inf/a0 is sqrt(2) less a term of order c/a0.
  EXPECT_NEAR(outer_ratio(parabola(5), 1e-8), std::sqrt(2), 1e-7);
  EXPECT_NEAR(outer_ratio(cone(0.3), 1e-8), pi / 2, 1e-7);
  for (const double n : {0.5, 1.3, 6.0, 20.0}) {
    EXPECT_GT(outer_ratio(power_law(1, n), 0.999999), 1);
    EXPECT_GT(outer_ratio(power_law(1, n), 1e-6), outer_ratio(power_law(1, n), 0.3));
  }
}

TEST(LimitingProfile, ParabolaAndConeHaveTheirClosedForms) {
  const double R = 5, d = 0.2, theta = 0.3;
  const double c = 0.6 * std::sqrt(R * d);
  const LimitingProfile sphere = limiting_profile(parabola(R), c, d);
  const double b = 0.6 * inverse_transform(cone(theta), d);
  const LimitingProfile spike = limiting_profile(cone(theta), b, d);
  for (const double s : {1.001, 1.1, 1.4, 1.7}) {
    const double r = s * c, q = s * b;
    const double worn_sphere =
        (r * r * std::asin(c / r) - c * std::sqrt(r * r - c * c)) / (pi * R) + 2 / pi * d * std::acos(c / r);
    const double worn_spike = std::tan(theta) * (q - std::sqrt(q * q - b * b)) + 2 / pi * d * std::acos(b / q);
    if (r < sphere.outer_radius) {
      EXPECT_NEAR(shape(sphere, r), worn_sphere, 1e-14);
    }
    if (q < spike.outer_radius) {
      EXPECT_NEAR(shape(spike, q), worn_spike, 1e-14);
    }
  }
}

// Paper (13) with x = r sin(t): (2/pi) int g dt, by adaptive Gauss-Kronrod to 1e-14.
TEST(LimitingProfile, IsTheBackTransform) {
  for (const double n : {0.5, 1.0, 1.3, 2.0, 3.7, 20.0}) {
    const Profile unworn = power_law(0.4, n);
    const double c = 0.5 * inverse_transform(unworn, 0.2);
    const LimitingProfile worn = limiting_profile(unworn, c, 0.2);
    for (const double s : {1e-6, 0.01, 0.5, 0.99}) {
      const double r = c + s * (worn.outer_radius - c);
      const double split = std::asin(c / r);
      boost::math::quadrature::tanh_sinh<double> quadrature;
      const double inner =
          quadrature.integrate([&](double t) { return transform(unworn, r * std::sin(t)); }, 0.0, split, 1e-14);
      EXPECT_NEAR(shape(worn, r), 2 / pi * (inner + 0.2 * (pi / 2 - split)), 1e-12) << "n = " << n << ", s = " << s;
    }
  }
}

TEST(LimitingProfile, UnwornInsideTheStickZoneAndFarOutside) {
  const LimitingProfile worn = limiting_profile(parabola(5), 0.5, 0.2);
  for (const double r : {0.0, 0.3, 0.5, worn.outer_radius, 2.0}) {
    EXPECT_EQ(shape(worn, r), shape(worn.unworn, r));
    EXPECT_EQ(worn_depth(worn, r), 0);
  }
  EXPECT_GT(worn_depth(worn, 0.7), 0.01);
  EXPECT_NEAR(worn_depth(worn, worn.outer_radius * (1 - 1e-9)), 0, 1e-9);
}

// Just outside c the worn depth is (2/pi)(d_max - g0(c)) arccos(c/r), with arccos(c/r) = sqrt(2 (r-c)/c); the terms
// left out are smaller by (r-c)/c.
TEST(LimitingProfile, AccurateNextToTheStickZone) {
  const LimitingProfile worn = limiting_profile(power_law(0.1, 1.7), 0.5, 0.2);
  const double jump = 0.2 - transform(worn.unworn, 0.5);
  for (const double gap : {std::ldexp(1.0, -40), std::ldexp(1.0, -50)}) {
    EXPECT_NEAR(worn_depth(worn, 0.5 + gap) / (2 / pi * jump * std::sqrt(4 * gap)), 1, 1e-11);
  }
}

TEST(LimitingProfile, TransformIsFlatBeyondTheStickRadius) {
  const LimitingProfile worn = limiting_profile(parabola(5), 0.5, 0.2);
  EXPECT_EQ(transform(worn, 0.4), transform(worn.unworn, 0.4));
  EXPECT_EQ(transform(worn, -0.6), 0.2);
}

TEST(LimitingProfile, ForceIsThatOfTheSpringsInTheStickZone) {
  const double G = 3;
  const LimitingProfile worn = limiting_profile(power_law(0.1, 1.7), 0.5, 0.2);
  for (const double d : {0.0, 0.01, 0.1, 0.2}) {
    const auto load = [&](double x) { return 8 * G * std::max(0.0, d - transform(worn, x)); };
    const double radius = std::min(0.5, inverse_transform(worn.unworn, d));
    const double expected =
        radius > 0 ? boost::math::quadrature::gauss_kronrod<double, 31>::integrate(load, 0.0, radius, 15, 1e-11) : 0;
    EXPECT_NEAR(limiting_normal_force(worn, G, d), expected, 1e-12);
  }
}

// With no stick zone left all of a parabola is gone that d_max reaches, int (d - r^2/2) 2 pi r dr = pi d^2 R; a sum of
// strips; nothing where all sticks.
TEST(LimitingProfile, WornVolumeIsTheIntegralOfTheDepth) {
  EXPECT_NEAR(worn_volume(limiting_profile(parabola(1), 1e-6, 1)), pi, 1e-5);
  EXPECT_EQ(worn_volume(limiting_profile(parabola(5), 1, 0.2)), 0);
  for (const auto& unworn : {parabola(5), cone(0.1)}) {
    const LimitingProfile worn = limiting_profile(unworn, 0.6, 0.2);
    constexpr int n = 200000;
    const double width = (worn.outer_radius - 0.6) / n;
    double sum = 0;
    for (int i = 0; i < n; ++i) {
      const double r = 0.6 + (i + 0.5) * width;
      sum += 2 * pi * r * worn_depth(worn, r) * width;
    }
    EXPECT_NEAR(worn_volume(worn) / sum, 1, 1e-7);
  }
}

TEST(LimitingProfile, RejectsBadArguments) {
  EXPECT_THROW(limiting_profile(parabola(5), 0, 0.2), std::invalid_argument);
  EXPECT_THROW(limiting_profile(parabola(5), nan, 0.2), std::invalid_argument);
  EXPECT_THROW(limiting_profile(parabola(5), 1.01, 0.2), std::invalid_argument);
  EXPECT_THROW(limiting_profile(parabola(5), 0.5, 0), std::invalid_argument);
  const LimitingProfile worn = limiting_profile(parabola(5), 0.5, 0.2);
  EXPECT_THROW(shape(worn, -1), std::invalid_argument);
  EXPECT_THROW(limiting_normal_force(worn, 1, 0.21), std::invalid_argument);
}

}  // namespace
}  // namespace fretval::mdr::limiting_profile_test
