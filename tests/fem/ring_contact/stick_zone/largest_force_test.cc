#include "fem/ring_contact/stick_zone/largest_force.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fem/support/constants.h"
#include "tests/fem/fretting.h"
#include "tests/fem/half_space.h"

namespace fretval::fem::largest_force_test {
namespace {

constexpr int n_steps = 180;

/// A cycle of given forces at the instants t_k = 2 pi k/n, k = 1..n.
template <typename Force>
NormalHistory cycle_of(const Force& force) {
  NormalHistory history;
  history.steps_per_cycle = n_steps;
  history.time = Eigen::VectorXd::LinSpaced(n_steps, 2 * pi / n_steps, 2 * pi);
  history.force = history.time.unaryExpr(force);
  history.force_uncertainty = history.force_beyond = history.force_beyond_uncertainty = Eigen::VectorXd::Zero(n_steps);
  return history;
}

/// Over the period of a history of a punch of 12 of 16 rings.
NormalHistory punch_history(const ContactProblem& problem, const RelaxationModel& model) {
  const auto profile = ring_means(problem.compliance, [](double r) { return r < 0.75 ? 0.0 : 10.0; });
  return normal_history(problem, model, profile, fretting_motion(), {72}).cycle;
}

// Its peak anywhere between samples, and next to the seam of the period. Of the scan of the quartic, 1.2e-8; a sample
// alone is up to 3e-4 below.
TEST(LargestForce, IsThePeakBetweenTheSamples) {
  for (const double peak : {0.001, 1.0, 1.013, 3.14, 2 * pi - 0.001}) {
    const auto largest =
        largest_force(cycle_of([=](double t) { return 3 + std::cos(t - peak) + 0.3 * std::cos(2 * (t - peak)); }));
    EXPECT_NEAR(largest.value, 4.3, 3e-8) << peak;
    EXPECT_LT(largest.uncertainty, 1e-6) << peak;
  }
}

// But for a worn profile, whose flank hardly touches.
TEST(LargestForce, CountsWhatPressesBeyondAFreeRing) {
  auto history = cycle_of([](double t) { return 3 + std::cos(t - 1); });
  history.force_beyond = history.time.unaryExpr([](double t) { return 0.5 + 0.25 * std::cos(t - 1); });
  EXPECT_NEAR(largest_force(history).value, 4.75, 1e-7);
  EXPECT_NEAR(largest_force(history, 1, Flank::around_contact).value, 4, 1e-7);
}

// All edges of a contact misread alike put its largest force off by as much.
TEST(LargestForce, IsAtLeastAsUncertainAsItsSamples) {
  auto history = cycle_of([](double t) { return 3 + std::cos(t - 0.01); });
  history.force_uncertainty.setConstant(1e-3);
  const auto largest = largest_force(history);
  EXPECT_GE(largest.uncertainty, 1e-3);
  EXPECT_LT(largest.uncertainty, 2e-3);
}

// F = F_1 (d0 + |G| Dd) by the complex modulus, whatever the phase, F_1 that of a unit indentation. Of the periodicity.
TEST(LargestForce, OfAFlatPunchFollowsTheComplexModulus) {
  const auto& problem = normal_half_space(16);
  const double unit_force = punch_traction(problem, 12).dot(problem.compliance.areas);
  for (const auto& model : {elastic_body(), standard_solid(), kelvin_voigt(), three_branches()}) {
    const double expected = unit_force * (0.8 + 0.2 * std::abs(complex_modulus(model)));
    EXPECT_NEAR(largest_force(punch_history(problem, model)).value / expected, 1, 1e-6);
  }
}

}  // namespace
}  // namespace fretval::fem::largest_force_test
