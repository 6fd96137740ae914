#include "fem/ring_contact/stick_zone/slip_decay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fem/ring_contact/stick_zone/stick_zones.h"
#include "fem/support/constants.h"
#include "tests/fem/fretting.h"
#include "tests/fem/half_space.h"

namespace fretval::fem::slip_decay_test {
namespace {

TEST(SlipDecay, IsTheLargestSlipInsideOverTheAmplitude) {
  FrictionHistory history;
  history.amplitude = 2;
  history.slip_of_periods = {Eigen::Vector3d(1, 3, 8), Eigen::Vector3d(0.5, 0, 8)};
  EXPECT_EQ(slip_decay(history, 2), (std::vector<double>{1.5, 0.25}));
  EXPECT_EQ(slip_decay(history, 3), (std::vector<double>{4, 4}));
  EXPECT_TRUE(slip_decay(history, 0).empty());
  history.amplitude = 0;
  EXPECT_TRUE(slip_decay(history, 2).empty());
}

// Two rings of areas 1 and 3, and c where another 1 is within it.
TEST(SlipDecay, OfTheMeanIsOverTheAreaInsideC) {
  FrictionHistory history;
  history.amplitude = 2;
  history.slip_of_periods = {Eigen::Vector3d(1, 3, 8), Eigen::Vector3d(0.5, 0, 8)};
  const auto means = [&](SlipBeyond beyond) {
    return mean_slip_of_periods(history, Eigen::Vector3d(1, 3, 5), 2, std::sqrt(5 / pi), beyond);
  };
  const auto constant = means(SlipBeyond::constant), linear = means(SlipBeyond::linear);
  ASSERT_EQ(constant.size(), 2U);
  EXPECT_NEAR(constant[0], (1 + 9 + 3) / 10.0, 1e-15);
  EXPECT_NEAR(constant[1], 0.05, 1e-15);
  // Over the root of pi rings end at 1 and 2, c is root 5; its part is (root 5 - 1)/2 rings beyond the second one.
  EXPECT_NEAR(linear[0], (1 + 9 + 3 + 2 * (std::sqrt(5.0) - 1) / 2) / 10, 1e-15);
}

FrictionHistory slipping(const std::vector<double>& slips) {
  FrictionHistory history;
  history.amplitude = 1;
  for (const double slip : slips) history.slip_of_periods.emplace_back(Eigen::VectorXd::Constant(1, slip));
  return history;
}

TEST(SlipDecay, HasAFactorInTheEnd) {
  const auto factor = decay_factor(slipping({9, 9, 8, 4.4, 2.2, 1, 0.25, 0}), 1, 2).value();
  EXPECT_EQ(factor.factor, 0.25);
  EXPECT_NEAR(factor.uncertainty, std::abs(0.25 - 1 / 2.2) * 1, 1e-15);  // root 1/2 over 1 - 1/2
  EXPECT_FALSE(decay_factor(slipping({9, 9, 8, 4, 2}), 1, 2)) << "too few";
  EXPECT_FALSE(decay_factor(slipping({1, 1, 1, 1, 1, 2, 3}), 1, 2)) << "grows";
  EXPECT_FALSE(decay_factor(slipping({9, 9, 0, 0, 0, 0, 0}), 1, 2)) << "ends at once";
  auto jumped = slipping({9, 9, 8, 4.4, 2.2, 1, 0.25});
  jumped.jumped = true;
  EXPECT_FALSE(decay_factor(jumped, 1, 2));
}

// A standard solid in fretting: one entry a period, the last of them that of the periodic state, and inside the
// shakedown radius slip falls from a good share of the amplitude to that of a stuck ring.
TEST(SlipDecay, EndsInShakedown) {
  HistoryControl control;
  control.steps_per_cycle = 48;
  const auto& problem = normal_half_space(32);
  const double mu = 0.5;
  const Motion motion = one_frequency(0.8, 0.2, 1.5 * mu * 0.2, 1.0);
  const auto history =
      contact_history(NormalContact(problem, standard_solid(), parabola_means(problem), motion, 48),
                      WatchedFriction(tangential_half_space(32), standard_solid(), mu, motion, 48), control)
          .friction;
  ASSERT_EQ(history.slip_of_periods.size(), static_cast<std::size_t>(history.n_cycles));
  EXPECT_EQ(history.slip_of_periods.back(), history.period_slip);
  const auto decay = slip_decay(history, stuck_rings(history, motion).shakedown);
  EXPECT_GT(*std::max_element(decay.begin(), decay.end()), 0.01);
  EXPECT_LE(decay.back() * history.amplitude, slip_of_stuck_ring(motion, history.amplitude));
  // One slip a period, in one step: G (lambda - q) + G1 g (lambda - 1) = 0 with the share g of a branch in a step.
  const auto body = standard_solid();
  const double time = body.times[0], dt = 2 * pi / 48, share = body.moduli[0] * time / dt * -std::expm1(-dt / time),
               expected = (std::exp(-2 * pi / time) + share) / (1 + share);
  const auto factor = decay_factor(history, stuck_rings(history, motion).shakedown, motion.cycles_of_ramp()).value();
  const double balance_inside_step = 2 * std::exp(-time / dt);  // of what the branch bears, see RelaxationStep
  EXPECT_NEAR(factor.factor, expected, 2 * balance_inside_step);
  EXPECT_LT(factor.uncertainty, 1e-4);
}

}  // namespace
}  // namespace fretval::fem::slip_decay_test
