#include "mdr/stick/slip_decay.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "mdr/springs/spring_step.h"
#include "mdr/support/constants.h"
#include "tests/mdr/error_of.h"

namespace fretval::mdr::slip_decay_test {
namespace {

TEST(SlipDecay, OfOneBranchIsItsClosedForm) {
  for (const double time : {0.05, 1.0, 40.0}) {
    const double q = std::exp(-1 / time);
    EXPECT_NEAR(slip_decay(prony(2, {6}, {time}), 1).value(), (2 * q + 6) / 8, 1e-14) << time;
  }
}

// The slips that keep an element within its limit, one after the other.
TEST(SlipDecay, IsThatOfSlipsWhichHoldTheLimit) {
  const auto body = prony(1, {2, 0.5, 3}, {0.3, 4, 0.9});
  const auto modulus = [&body](double t) {
    double sum = body.relaxed_modulus;
    for (std::size_t i = 0; i < body.branch_times.size(); ++i)
      sum += body.branch_moduli[i] * std::exp(-t / body.branch_times[i]);
    return sum;
  };
  std::vector<double> slips;
  for (int n = 0; n < 200; ++n) {
    double left = 1;
    for (int k = 0; k < n; ++k) left -= slips[static_cast<std::size_t>(k)] * modulus(n - k);
    slips.push_back(left / modulus(0));
  }
  EXPECT_NEAR(slip_decay(body, 1).value(), slips[199] / slips[198], 1e-9);
}

/// Slip of one spring in each period of 1 s, between first slip and shakedown, from rest on.
std::vector<double> slips_of_a_spring(const PronyBody& body, int n_periods) {
  constexpr double mu = 0.5;
  constexpr int n_steps = 2000;
  const Eigen::ArrayXd one = Eigen::ArrayXd::Ones(1);
  const SpringBed bed{one, one, 0.7 * one};
  const SpringStep step(body, mu, 1.0 / n_steps);
  SpringState state = relaxed_state(bed, body, 1);
  std::vector<double> slips;
  for (int period = 0; period < n_periods; ++period) {
    slips.push_back(0);
    for (int k = 1; k <= n_steps; ++k) {
      const double t = 2 * pi * k / n_steps, rate = 2 * pi, rise = period == 0 ? 1.0 * k / n_steps : 1,
                   growth = period == 0 ? 1 : 0, pull = 0.15 * 1.5 * mu;
      const double e = rise * std::cos(t), e_rate = growth * std::cos(t) - rise * rate * std::sin(t);
      step.advance(state, bed, {1 + 0.2 * e, 0.2 * e_rate, pull * e, pull * e_rate});
      slips.back() += std::abs(state.slip[0]);
    }
  }
  return slips;
}

// First order in the step.
TEST(SlipDecay, IsThatOfASteppedSpring) {
  const auto body = prony(1, {0.3, 0.2}, {0.2, 1.5});
  const auto slips = slips_of_a_spring(body, 24);
  EXPECT_GT(slips[1], 1e-4);
  EXPECT_NEAR(slips[23] / slips[22], slip_decay(body, 1).value(), 2e-3);
}

// A dashpot: like n^(-3).
TEST(SlipDecay, WithADashpotHasNoFactor) {
  const auto slips = slips_of_a_spring(kelvin_voigt(1, 0.03), 129);
  EXPECT_NEAR(std::log2(slips[64] / slips[128]), 3, 0.3);
}

TEST(SlipDecay, NeedsBranchesAndNoDashpot) {
  EXPECT_FALSE(slip_decay(elastic(1), 1));
  EXPECT_FALSE(slip_decay(prony(1, {1}, {1}, 0.1), 1));
  EXPECT_NE(error_of([] { static_cast<void>(slip_decay(elastic(1), 0)); }), "accepted");
}

}  // namespace
}  // namespace fretval::mdr::slip_decay_test
