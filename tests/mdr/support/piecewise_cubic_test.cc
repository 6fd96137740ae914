#include "mdr/support/piecewise_cubic.h"

#include <gtest/gtest.h>

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <vector>

namespace fretval::mdr::piecewise_cubic_test {
namespace {

const std::vector<double> nodes = {0, 0.3, 0.35, 1.1, 2};
const PiecewiseCubic wavy = hermite_cubic(nodes, {0, 0.2, 0.1, 1.4, 1.3}, {0.5, -1, 2, 0.3, -2});

TEST(PiecewiseCubic, HermiteMeetsValuesAndSlopes) {
  const PiecewiseCubic slope = derivative(wavy);
  EXPECT_NEAR(value(wavy, 0.35), 0.1, 1e-15);
  EXPECT_NEAR(value(wavy, 2), 1.3, 1e-14);
  EXPECT_NEAR(value(slope, 1.1), 0.3, 1e-14);
  EXPECT_NEAR(value(slope, 2), -2, 1e-13);
  const double h = 1e-6;
  EXPECT_NEAR((value(wavy, 0.7 + h) - value(wavy, 0.7 - h)) / (2 * h), value(slope, 0.7), 1e-9);
}

TEST(PiecewiseCubic, IntegralIsThatOfAQuadrature) {
  boost::math::quadrature::tanh_sinh<double> quadrature;
  double expected = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double end = k == 2 ? 0.8 : nodes[k + 1];
    expected += quadrature.integrate([&](double x) { return value(wavy, x); }, nodes[k], end, 1e-14);
  }
  EXPECT_NEAR(integral(wavy, 0.8), expected, 1e-13);
}

// Substitutions x = r sin(t), x = r cosh(t), piece by piece; the last radius is far outside, where the kernel is
// smooth.
TEST(PiecewiseCubic, AbelIntegralsAreThoseOfAQuadrature) {
  boost::math::quadrature::tanh_sinh<double> quadrature;
  const auto sum = [&](double from, double to, const auto& angle, const auto& integrand) {
    double total = 0;
    for (std::size_t k = 0; k + 1 < nodes.size(); ++k) {
      const double lower = std::max(from, nodes[k]), upper = std::min(to, nodes[k + 1]);
      if (lower < upper) total += quadrature.integrate(integrand, angle(lower), angle(upper), 1e-14);
    }
    return total;
  };
  for (const double r : {0.2, 0.35, 0.9, 2.0, 37.0}) {
    const double upper = std::min(r, 1.7), lower = 0.3 * upper;
    const double below = sum(
        lower, upper, [r](double x) { return std::asin(x / r); },
        [r](double t) { return value(wavy, r * std::sin(t)); });
    EXPECT_NEAR(abel_integral_below(wavy, lower, upper, r), below, 1e-12 * (1 + r)) << r;
    if (r > 1.7) continue;
    const double above = sum(
        r, 1.7, [r](double x) { return std::acosh(x / r); }, [r](double t) { return value(wavy, r * std::cosh(t)); });
    EXPECT_NEAR(abel_integral_above(wavy, r, 1.7), above, 1e-12) << r;
  }
}

// A hat of height 1/h and width 2 h has the integral 1, so its Abel integrals tend to the kernel at its place, to the
// next order h^2/10 of the kernel's second derivative. Powers of x about the axis would lose (x/h)^3 here.
TEST(PiecewiseCubic, NarrowPiecesFarFromTheAxisKeepTheirDigits) {
  for (const double h : {1e-2, 1e-4, 1e-6}) {
    const PiecewiseCubic hat = hermite_cubic({0, 0.5 - h, 0.5, 0.5 + h, 1}, {0, 0, 1 / h, 0, 0}, {0, 0, 0, 0, 0});
    const double roundoff = 1e-15 / h;  // of the nodes over h
    EXPECT_NEAR(abel_integral_below(hat, 0, 0.9, 0.9) * std::sqrt(0.81 - 0.25), 1, 0.5 * h * h + roundoff) << h;
    EXPECT_NEAR(abel_integral_above(hat, 0.1, 1) * std::sqrt(0.25 - 0.01), 1, 0.7 * h * h + roundoff) << h;
  }
}

TEST(PiecewiseCubic, AtTheAxisTheOuterIntegralNeedsAZero) {
  const PiecewiseCubic line = hermite_cubic({0, 1}, {0, 1}, {1, 1});
  EXPECT_NEAR(abel_integral_above(line, 0, 1), 1, 1e-15);
  EXPECT_TRUE(std::isinf(abel_integral_above(hermite_cubic({0, 1}, {1, 2}, {1, 1}), 0, 1)));
}

TEST(PiecewiseCubic, MonotoneSlopesAreExactForQuadraticsAndNeverOvershoot) {
  const std::vector<double> x = {0, 0.1, 0.3, 0.35, 0.8};
  std::vector<double> y;
  y.reserve(x.size());
  for (const double t : x) y.push_back(3 * t * t + t);
  const std::vector<double> slopes = monotone_slopes(x, y);
  for (std::size_t k = 0; k < x.size(); ++k) EXPECT_NEAR(slopes[k], 6 * x[k] + 1, 1e-13);

  const PiecewiseCubic step = hermite_cubic(x, {0, 0, 0, 1, 1}, monotone_slopes(x, {0, 0, 0, 1, 1}));
  double before = 0;
  for (int k = 0; k <= 800; ++k) {
    const double y_k = value(step, k / 1000.0);
    EXPECT_GE(y_k, before - 1e-12);
    EXPECT_LE(y_k, 1 + 1e-12);
    before = y_k;
  }
}

}  // namespace
}  // namespace fretval::mdr::piecewise_cubic_test
