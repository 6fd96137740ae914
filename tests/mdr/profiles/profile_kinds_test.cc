#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "mdr/profiles/indentation.h"
#include "mdr/profiles/profile.h"
#include "mdr/stick/limiting_profile.h"
#include "mdr/support/constants.h"

namespace fretval::mdr::profile_kinds_test {
namespace {

const double b = 0.4;  // flat radius

std::vector<double> uniform(std::size_t n, double end) {
  std::vector<double> x;
  for (std::size_t k = 0; k <= n; ++k) x.push_back(end * static_cast<double>(k) / static_cast<double>(n));
  return x;
}

std::vector<double> heights(const Profile& profile, const std::vector<double>& r) {
  std::vector<double> f;
  f.reserve(r.size());
  for (const double radius : r) f.push_back(shape(profile, radius));
  return f;
}

// Uneven rows, denser in the middle.
std::vector<double> uneven(std::size_t n, double end) {
  std::vector<double> x = uniform(n, 1);
  for (double& t : x) t = end * (t + 0.1 * std::sin(2 * pi * t));
  return x;
}

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

TEST(ProfileTable, OfAPowerLawHasItsTransformPressureAndForce) {
  const Profile exact = parabola(2);
  for (const auto& r : {uniform(20, 1), uneven(35, 1)}) {
    const Profile table = tabulated(r, heights(exact, r));
    // Quadratics are interpolated exactly, so are their transforms.
    for (const double x : {1e-3, 0.3, 0.77, 1.0}) {
      EXPECT_NEAR(transform(table, x), transform(exact, x), 1e-13);
      EXPECT_NEAR(transform_slope(table, x), transform_slope(exact, x), 1e-11);
      EXPECT_NEAR(transform_integral(table, x), transform_integral(exact, x), 1e-13);
      EXPECT_NEAR(inverse_transform(table, transform(exact, x)), x, 1e-12);
    }
    for (const double s : {0.0, 0.31, 0.69})
      EXPECT_NEAR(pressure(table, 1, 0.25, s), pressure(exact, 1, 0.25, s), 1e-12);
    EXPECT_NEAR(worn_depth(limiting_profile(table, 0.3, 0.2), 0.5), worn_depth(limiting_profile(exact, 0.3, 0.2), 0.5),
                1e-13);
  }
}

TEST(ProfileTable, ConvergesForOtherShapes) {
  const Profile exact = power_law(0.3, 3.4);
  double before = 0;
  for (const std::size_t n : {25, 50, 100, 200}) {
    const auto r = uniform(n, 1);
    const double error = std::abs(transform(tabulated(r, heights(exact, r)), 0.77) / transform(exact, 0.77) - 1);
    // The slopes of three-point parabolas are of second order.
    if (before > 0) {
      EXPECT_GT(before / error, 3.2) << n;
    }
    before = error;
  }
  EXPECT_LT(before, 3e-5);
}

TEST(ProfileTable, RoundTripOfSmoothAndNoisyTables) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> noise(-1, 1);
  for (const double amplitude : {0.0, 2e-5}) {
    const auto r = uneven(120, 1);
    auto f = heights(parabola(2), r);
    for (std::size_t k = 0; k < f.size(); ++k) f[k] += amplitude * r[k] * noise(random);
    const Profile table = tabulated(r, f);
    for (const double x : {0.05, 0.333, 0.9}) {
      const double back = 2 / pi * abel_depth_integral(table, 0, x, x);  // paper (4)
      EXPECT_NEAR(back / shape(table, x), 1, amplitude > 0 ? 1e-6 : 1e-14) << amplitude << " at " << x;
    }
  }
}

TEST(ProfileTable, FlatFaceAndKinkAreMet) {
  const Profile exact = truncated_sphere(3, b);
  auto r = uniform(400, 1);
  const Profile table = tabulated(r, heights(exact, r));
  EXPECT_NEAR(inverse_transform(table, 0), b, 1e-12);
  EXPECT_NEAR(normal_force(table, 1, 0.1) / normal_force(exact, 1, 0.1), 1, 1e-4);
}

void expect_refusal(const std::vector<double>& r, const std::vector<double>& f, const std::string& words) {
  try {
    tabulated(r, f);
    FAIL() << words;
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

TEST(ProfileTable, NamesWhatIsWrong) {
  expect_refusal({0, 1, 2}, {0, 1, 2}, "at least 4");
  expect_refusal({0, 1, 2, 3}, {0, 1, 2}, "3 heights");
  expect_refusal({0.1, 1, 2, 3}, {0, 1, 2, 3}, "first radius");
  expect_refusal({0, 1, 1, 3}, {0, 1, 2, 3}, "in row 3");
  expect_refusal({0, 1, 2, 3}, {0, 1, NAN, 3}, "in row 3");
  expect_refusal({0, 1, 2, 3}, {0, -1, -2, -3}, "largest slope");
  // A dip at r = 2: the image falls there.
  expect_refusal({0, 1, 1.9, 2, 2.1, 3}, {0, 1, 3, 1, 3.2, 9}, "would not be a full circle");
  const Profile table = tabulated({0, 1, 2, 3}, {0, 1, 4, 9});
  EXPECT_THROW(shape(table, 3.1), std::invalid_argument);
  EXPECT_THROW(inverse_transform(table, 20), std::invalid_argument);
  EXPECT_THROW(limiting_profile(table, 2, 17), std::invalid_argument);
  EXPECT_EQ(end_radius(table), 3);
}

// Hermite cubics would dip before the kink, where straight lines meet it from either side or both.
TEST(ProfileTable, ConvexRowsWithAKinkAreAccepted) {
  for (const double bend : {0.0, 0.3, 1.0}) {
    for (const double kink : {0.3, 0.5, 0.51}) {
      const auto f = [=](double r) {
        return 0.2 * r + bend * r * r / 2 + std::max(0.0, r - kink) + (bend == 0.3 ? 0 : std::pow(r, 4));
      };
      const auto r = uniform(50, 1);
      std::vector<double> rows;
      rows.reserve(r.size());
      for (const double radius : r) rows.push_back(f(radius));
      const Profile table = tabulated(r, rows);
      double slope_before = 0;
      for (int k = 1; k < 997; ++k) {
        const double slope = (shape(table, k / 997.0) - shape(table, (k - 1) / 997.0)) * 997;
        EXPECT_GE(slope, slope_before - 3e-3) << k;  // the narrow bend of a kink between straight lines
        slope_before = slope;
      }
      for (std::size_t k = 0; k < r.size(); ++k) EXPECT_NEAR(shape(table, r[k]), rows[k], 1e-14);
    }
  }
}

// A profile that is concave in places is no obstacle as long as its image rises.
TEST(ProfileTable, ConcaveFlankIsAllowed) {
  const auto r = uniform(60, 1);
  EXPECT_NO_THROW(tabulated(r, heights(power_law(1, 0.8), r)));
}

}  // namespace
}  // namespace fretval::mdr::profile_kinds_test
