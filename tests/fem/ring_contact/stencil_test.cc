#include "fem/ring_contact/stencil.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fretval::fem::stencil_test {
namespace {

using Eigen::Index;

/// Uneven nodes around zero.
Eigen::VectorXd nodes() {
  return Eigen::VectorXd::LinSpaced(10, -1, 1).array() + 0.03 * Eigen::VectorXd::LinSpaced(10, 0, 30).array().sin();
}

// Degree n - 1 is reproduced anywhere, degree n is not. Roundoff of the divided differences, 1e-16 over the spacing.
TEST(Stencil, IsExactForItsDegree) {
  const Eigen::VectorXd x = nodes();
  for (Index n = 1; n <= 8; ++n)
    for (const Index first : {0, 2}) {
      const auto error = [&](Index degree) {
        const auto power = [=](double at) { return std::pow(at - 0.3, static_cast<double>(degree)); };
        return std::abs(Stencil{x, x.unaryExpr(power), first, n}(0.9) - power(0.9));
      };
      for (Index degree = 0; degree < n; ++degree) EXPECT_LT(error(degree), 1e-12) << n << ' ' << degree;
      EXPECT_GT(error(n), 1e-6) << n;
    }
  EXPECT_EQ((Stencil{x, x, 3, 0}(0.5)), 0);
}

TEST(Stencil, IntegralIsExactForACubic) {
  const Eigen::VectorXd x = nodes();
  const auto integral = [&](int degree) {
    return Stencil{x, x.array().pow(degree).matrix(), 3, 5}.integral(-0.2, 0.9);
  };
  const auto exact = [](int degree) { return (std::pow(0.9, degree + 1) - std::pow(-0.2, degree + 1)) / (degree + 1); };
  for (int degree = 0; degree <= 3; ++degree) EXPECT_NEAR(integral(degree), exact(degree), 1e-14) << degree;
  EXPECT_GT(std::abs(integral(4) - exact(4)), 1e-3);
}

TEST(Stencil, RootNeedsASignChange) {
  const auto rising = [](double x) { return x * x - 2; };
  const auto falling = [](double x) { return 2 - x * x; };
  EXPECT_NEAR(root_between(rising, 0, 2).value(), std::sqrt(2), 1e-13);
  EXPECT_NEAR(root_between(falling, 1, 8).value(), std::sqrt(2), 1e-12);
  EXPECT_FALSE(root_between(rising, 1.5, 2));
  EXPECT_FALSE(root_between([](double) { return std::nan(""); }, 0, 2));
}

// The lines 1 - r and (r - a)/2 meet at (2 + a)/3; looked for between the nodes 0.5 and 0.6 and 0.01 beyond.
TEST(Stencil, PolynomialsMeetBetweenTheirNodesOrHardlyBeyond) {
  const Eigen::Vector4d x(0.4, 0.5, 0.6, 0.7);
  const auto meet_at = [&](double radius) {
    const double a = 3 * radius - 2;
    const Eigen::VectorXd inner = 1 - x.array(), outer = (x.array() - a) / 2;
    return meeting_point({x, inner, 0, 2}, {x, outer, 2, 2});
  };
  for (const double radius : {0.492, 0.5, 0.57, 0.608}) EXPECT_NEAR(meet_at(radius).value(), radius, 1e-13);
  for (const double radius : {0.488, 0.612}) EXPECT_FALSE(meet_at(radius)) << radius;
}

}  // namespace
}  // namespace fretval::fem::stencil_test
