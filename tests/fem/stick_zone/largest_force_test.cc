#include "fem/stick_zone/largest_force.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fem/support/constants.h"
#include "tests/fem/fretting.h"
#include "tests/fem/half_space.h"

namespace fretval::fem::largest_force_test {
namespace {

/// A cycle of given forces and contact radii at the instants t_k = 2 pi k/n, k = 1..n.
template <typename Force, typename Radius>
NormalHistory cycle_of(int n_steps, const Force& force, const Radius& radius) {
  NormalHistory history;
  history.steps_per_cycle = n_steps;
  history.time = Eigen::VectorXd::LinSpaced(n_steps, 2 * pi / n_steps, 2 * pi);
  history.force = history.time.unaryExpr(force);
  history.contact_radius = history.time.unaryExpr(radius);
  history.force_uncertainty = history.force_beyond = history.force_beyond_uncertainty = Eigen::VectorXd::Zero(n_steps);
  return history;
}

constexpr auto resting = [](double) { return 0.7; };

/// Over the period of a history of a punch of 12 of 16 rings.
NormalHistory punch_history(const ContactProblem& problem, const RelaxationModel& model) {
  const auto profile = ring_means(problem.compliance, [](double r) { return r < 0.75 ? 0.0 : 10.0; });
  return normal_history(problem, model, profile, fretting_motion(), {72}).cycle;
}

// Its peak anywhere between samples, and next to the seam of the period. Of the scan of the quartic, 1.2e-8; a sample
// alone is up to 3e-4 below.
TEST(LargestForce, IsThePeakBetweenTheSamples) {
  const auto body = elastic_body();
  for (const double peak : {0.001, 1.0, 1.013, 3.14, 2 * pi - 0.001}) {
    const auto history = cycle_of(
        180, [=](double t) { return 3 + std::cos(t - peak) + 0.3 * std::cos(2 * (t - peak)); }, resting);
    const auto largest = largest_force(normal_half_space(16), {body}, history);
    EXPECT_NEAR(largest.value, 4.3, 3e-8) << peak;
    EXPECT_LT(largest.uncertainty, 1e-6) << peak;
  }
}

// But for a worn profile, whose flank hardly touches.
TEST(LargestForce, CountsWhatPressesBeyondAFreeRing) {
  const auto body = elastic_body();
  auto history = cycle_of(
      180, [](double t) { return 3 + std::cos(t - 1); }, resting);
  history.force_beyond = history.time.unaryExpr([](double t) { return 0.5 + 0.25 * std::cos(t - 1); });
  EXPECT_NEAR(largest_force(normal_half_space(16), {body}, history).value, 4.75, 1e-7);
  EXPECT_NEAR(largest_force(normal_half_space(16), {body, std::nullopt, true}, history).value, 4, 1e-7);
}

// All edges of a contact misread alike put its largest force off by as much.
TEST(LargestForce, IsAtLeastAsUncertainAsItsSamples) {
  const auto body = elastic_body();
  auto history = cycle_of(
      180, [](double t) { return 3 + std::cos(t - 0.01); }, resting);
  history.force_uncertainty.setConstant(1e-3);
  const auto largest = largest_force(normal_half_space(16), {body}, history);
  EXPECT_GE(largest.uncertainty, 1e-3);
  EXPECT_LT(largest.uncertainty, 2e-3);
}

// F = F_1 (d0 + |G| Dd) by the complex modulus, whatever the phase, F_1 that of a unit indentation. Of the periodicity.
TEST(LargestForce, OfAFlatPunchFollowsTheComplexModulus) {
  const auto& problem = normal_half_space(16);
  const double unit_force = punch_traction(problem, 12).dot(problem.compliance.areas);
  for (const auto& model : {elastic_body(), standard_solid(), kelvin_voigt(), three_branches()}) {
    const double expected = unit_force * (0.8 + 0.2 * std::abs(complex_modulus(model)));
    EXPECT_NEAR(largest_force(problem, {model}, punch_history(problem, model)).value / expected, 1, 1e-6);
  }
}

// F = 8 a d: rings act like a punch smaller by a tenth of a ring, which nothing but the sharp edge tells.
TEST(LargestForce, AtASharpEdgeIsUncertainByItsRing) {
  const auto& problem = normal_half_space(16);
  const auto body = elastic_body();
  const auto history = punch_history(problem, body);
  const double error = std::abs(largest_force(problem, {body}, history).value - 8 * 0.75);
  EXPECT_GT(error, largest_force(problem, {body}, history).uncertainty);
  EXPECT_LT(error, largest_force(problem, {body, 0.75}, history).uncertainty);
}

// Memory may carry what a resting edge hides. An edge that travels over twelve rings hides a millionth of that.
TEST(LargestForce, OfABodyWithMemoryIsUncertainWhereItsEdgeRests) {
  const auto& problem = normal_half_space(16);
  const auto elastic = elastic_body();
  const auto force = [](double t) { return 3 + std::cos(t); };
  for (const auto& body : {standard_solid(), kelvin_voigt()}) {
    const auto of_memory = [&](const NormalHistory& history) {
      return largest_force(problem, {body}, history).uncertainty -
             largest_force(problem, {elastic}, history).uncertainty;
    };
    const double hidden = of_memory(cycle_of(180, force, resting));
    EXPECT_GT(hidden, 0.02);  // of the amplitude 1; as much was missed
    EXPECT_LT(of_memory(cycle_of(180, force, [](double t) { return 0.6 + 0.375 * std::cos(t); })), 1e-4 * hidden);
  }
}

}  // namespace
}  // namespace fretval::fem::largest_force_test
