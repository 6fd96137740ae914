#include "mdr/profiles/flat_faced.h"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>

#include "mdr/profiles/indentation.h"
#include "mdr/profiles/profile.h"
#include "mdr/stick/limiting_profile.h"
#include "mdr/support/constants.h"

namespace fretval::mdr::flat_faced_test {
namespace {

const double b = 0.4;  // flat radius

// Paper (3) with r = x sin(t) from the flat on, and its inverse (4), to 1e-13 by a quadrature.
double numeric_transform(const Profile& profile, double x, double flat) {
  boost::math::quadrature::tanh_sinh<double> quadrature;
  return quadrature.integrate([&](double t) { return x * shape_slope(profile, x * std::sin(t)); }, std::asin(flat / x),
                              pi / 2, 1e-14);
}

double numeric_back_transform(const Profile& profile, double r, double flat) {
  boost::math::quadrature::tanh_sinh<double> quadrature;
  return quadrature.integrate([&](double t) { return 2 / pi * transform(profile, r * std::sin(t)); },
                              std::asin(flat / r), pi / 2, 1e-14);
}

// f = s t + t^2/(2 R) with t = r - b = 0.1 or 0.6.
TEST(FlatFaced, IsFlatAndThenRises) {
  const FlatFaced sharp{b, 0.5, 2};
  for (const double r : {0.0, 0.2, b}) EXPECT_EQ(shape(sharp, r), 0);
  EXPECT_EQ(shape_slope(sharp, 0.39), 0);
  EXPECT_NEAR(shape(sharp, 0.5), 0.05 + 0.01, 1e-16);
  EXPECT_NEAR(shape_slope(sharp, 0.5), 0.5 + 0.2, 1e-15);
  EXPECT_NEAR(shape(rounded_flat(b, 4), 1), 0.36 / 8, 1e-16);
  EXPECT_NEAR(shape(truncated_sphere(4, b), 1), (1 - 0.16) / 8, 1e-16);
  EXPECT_EQ(transform_slope(rounded_flat(b, 4), b), 0);
  EXPECT_TRUE(std::isinf(transform_slope(truncated_sphere(4, b), b)));
}

TEST(FlatFaced, TransformAndBackTransformMakeARoundTrip) {
  for (const Profile& profile : {rounded_flat(b, 2), truncated_sphere(3, b), Profile(FlatFaced{b, 0.7, 0})}) {
    for (const double x : {0.40001, 0.5, 0.9, 7.0}) {
      EXPECT_NEAR(transform(profile, x) / numeric_transform(profile, x, b), 1, 1e-10) << x;
      EXPECT_NEAR(numeric_back_transform(profile, x, b) / shape(profile, x), 1, 1e-10) << x;
    }
    EXPECT_EQ(transform(profile, b), 0);
    EXPECT_EQ(inverse_transform(profile, 0), b);
    for (const double x : {0.4001, 0.6, 30.0})
      EXPECT_NEAR(inverse_transform(profile, transform(profile, x)) / x, 1, 1e-12);
  }
}

// Known force of a truncated cone and of a sphere with a flat: F = 8 G (a d - int g) with g in closed form, Popov and
// Hess (2015), chapter 2.
TEST(FlatFaced, ForcesOfTruncatedConeAndSphere) {
  const double G = 2, a = 0.7;
  const double root = std::sqrt(a * a - b * b), angle = std::acos(b / a);
  const double slope = 0.3, R = 3;
  const Profile truncated_cone = FlatFaced{b, slope, 0};
  const double d_cone = transform(truncated_cone, a);
  EXPECT_NEAR(d_cone, slope * a * angle, 1e-14);
  EXPECT_NEAR(normal_force(truncated_cone, G, d_cone), 4 * G * slope * a * a * (angle + b / a * root / a), 1e-12);
  const double d_sphere = transform(truncated_sphere(R, b), a);
  EXPECT_NEAR(d_sphere, a / R * root, 1e-14);
  EXPECT_NEAR(normal_force(truncated_sphere(R, b), G, d_sphere), 8 * G / (3 * R) * (2 * a * a + b * b) * root, 1e-12);
}

TEST(FlatFaced, SmallAnglesJoinTheClosedForms) {
  // A step in the number of digits at the angle where the series of closed forms take over would show here.
  const double x = b / std::cos(0.3);
  for (const Profile& profile : {rounded_flat(b, 2), truncated_sphere(3, b)}) {
    const double below = transform_integral(profile, x * (1 - 1e-15)),
                 above = transform_integral(profile, x * (1 + 1e-15));
    EXPECT_NEAR(above / below, 1, 1e-12);
    const double h = 1e-5;
    for (const double y : {0.41, 0.45, 0.8}) {
      const double slope = (transform_integral(profile, y + h) - transform_integral(profile, y - h)) / (2 * h);
      EXPECT_NEAR(slope, transform(profile, y), 1e-7);  // h^2 g''
      EXPECT_NEAR((transform(profile, y + h) - transform(profile, y - h)) / (2 * h), transform_slope(profile, y), 1e-5);
    }
  }
}

// The pressure integrates to the force, on both sides of the edge of the flat, where it is singular if sharp. There
// r = b -+ L t^4 leaves t^3 log(t), which a Gauss rule of 30 points meets to 1e-9; t^2 does for the root at r = a.
TEST(FlatFaced, PressureIntegratesToTheForce) {
  const double a = 0.6, G = 2;
  for (const Profile& profile : {rounded_flat(b, 2), truncated_sphere(3, b)}) {
    const double d = transform(profile, a);
    const auto ring = [&](double from, double to, int power) {
      const auto integrand = [&](double t) {
        const double r = from + (to - from) * std::pow(t, power);
        return 2 * pi * r * pressure(profile, G, d, r) * std::abs(to - from) * power * std::pow(t, power - 1);
      };
      return boost::math::quadrature::gauss<double, 30>::integrate(integrand, 0.0, 1.0);
    };
    const double force = ring(b, 0, 4) + ring(b, 0.5, 4) + ring(a, 0.5, 2);
    EXPECT_NEAR(force / normal_force(profile, G, d), 1, 1e-9);
  }
  EXPECT_TRUE(std::isinf(pressure(truncated_sphere(3, b), 2, 0.1, b)));
  EXPECT_TRUE(std::isfinite(pressure(rounded_flat(b, 2), 2, 0.1, b)));
}

// A vanishing flat gives the parabola back, a vanishing edge radius the flat punch 8 G b d.
TEST(FlatFaced, Limits) {
  const double d = 0.05;
  EXPECT_NEAR(normal_force(rounded_flat(1e-7, 2), 2, d) / normal_force(parabola(2), 2, d), 1, 1e-5);
  EXPECT_NEAR(normal_force(truncated_sphere(2, 1e-7), 2, d) / normal_force(parabola(2), 2, d), 1, 1e-12);
  EXPECT_NEAR(normal_force(rounded_flat(b, 1e-12), 2, d) / (8 * 2 * b * d), 1, 1e-4);
}

TEST(FlatFaced, LimitingProfileIsTheBackTransform) {
  const Profile unworn = truncated_sphere(3, b);
  const double d = 0.2, c = 0.6;
  const LimitingProfile worn = limiting_profile(unworn, c, d);
  EXPECT_GT(worn.outer_radius, inverse_transform(unworn, d));
  boost::math::quadrature::tanh_sinh<double> quadrature;
  for (const double s : {0.01, 0.5, 0.99}) {
    const double r = c + s * (worn.outer_radius - c), split = std::asin(c / r);
    const double inner = quadrature.integrate([&](double t) { return transform(unworn, r * std::sin(t)); },
                                              std::asin(b / r), split, 1e-14);
    EXPECT_NEAR(shape(worn, r), 2 / pi * (inner + d * (pi / 2 - split)), 1e-12);
  }
}

}  // namespace
}  // namespace fretval::mdr::flat_faced_test
