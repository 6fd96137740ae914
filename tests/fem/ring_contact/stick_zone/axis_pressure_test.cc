#include "fem/ring_contact/stick_zone/axis_pressure.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fem/ring_contact/static_contact.h"
#include "fem/support/constants.h"
#include "tests/fem/fretting.h"
#include "tests/fem/half_space.h"
#include "tests/worse.h"

namespace fretval::fem::axis_pressure_test {
namespace {

/// Of f = r^n on an elastic body, over the exact p(0) = (4/pi) kappa n/(n - 1) a^(n - 1).
double relative_pressure(const ContactProblem& problem, double n, double a) {
  const double kappa = std::sqrt(pi) / 2 * n * std::tgamma(n / 2) / std::tgamma((n + 1) / 2);
  const auto profile = ring_means(problem.compliance, [n](double r) { return std::pow(r, n); });
  const auto contact = static_contact(problem, profile, kappa * std::pow(a, n));
  return axis_pressure_max(problem.series, contact.pressure, Eigen::VectorXd::Constant(1, a), n).value() /
         (4 / pi * kappa * n / (n - 1) * std::pow(a, n - 1));
}

double worst_error(unsigned n_rings, double n) {
  double worst = 0;
  for (int k = 0; k <= 8; ++k)
    worst = worse(worst, std::abs(relative_pressure(normal_half_space(n_rings), n, 0.9 + k / 200.0) - 1));
  return worst;
}

// The mean pressure of the innermost ring is 2e-4 off at 32 rings and scatters as the edge crosses its ring.
TEST(AxisPressure, IsThatOfTheExactSolutionWhereverTheEdgeIs) {
  EXPECT_LT(worst_error(32, 2), 7e-6);
  EXPECT_LT(worst_error(32, 4), 5e-5);
  EXPECT_LT(worst_error(32, 1.5), 2e-5);
  EXPECT_LT(worst_error(32, 1.1), 3e-5);
  EXPECT_LT(worst_error(64, 2), 5e-6);
}

// A contact of a few rings does not count, and where there is no other nothing is known.
TEST(AxisPressure, IsTheLargestOfThePeriod) {
  const auto& problem = normal_half_space(32);
  const auto large = hertz_contact(problem, 0.81), small = hertz_contact(problem, 0.005);
  Eigen::MatrixXd pressure(problem.n_rings(), 4);
  pressure << small.pressure, large.pressure, small.pressure, Eigen::VectorXd::Zero(problem.n_rings());
  const Eigen::Vector4d radius(0.07, 0.9, 0.07, 0);
  const auto alone = axis_pressure_max(problem.series, large.pressure, radius.segment(1, 1), 2);
  EXPECT_DOUBLE_EQ(axis_pressure_max(problem.series, pressure, radius, 2).value(), alone.value());
  EXPECT_FALSE(axis_pressure_max(problem.series, small.pressure, radius.head(1), 2));
}

// As Hertz has it, in proportion to the radius: here of six rings, one more than it is read from.
TEST(AxisPressure, OfAContactOfSixRingsCounts) {
  const auto& problem = normal_half_space(32);
  EXPECT_NEAR(relative_pressure(problem, 2, 0.19), 1, 0.02);
}

}  // namespace
}  // namespace fretval::fem::axis_pressure_test
