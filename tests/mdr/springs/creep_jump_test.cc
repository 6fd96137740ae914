#include "mdr/springs/creep_jump.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "mdr/profiles/power_law.h"
#include "mdr/springs/repetition.h"
#include "mdr/support/constants.h"

namespace fretval::mdr::creep_jump_test {
namespace {

constexpr double mu = 0.5;

// Both tips and one memory drift towards 0 by a known share of themselves a period.
SpringState scaled(double size) {
  SpringState state{};
  state.normal_depth = Eigen::Array2d(size, 0);
  state.normal_load = Eigen::Array2d(1 + size, 1);
  state.tangential_load = state.tangential_shift = Eigen::Array2d::Zero();
  state.normal_memory = state.tangential_memory = Eigen::Array2d::Zero();
  return state;
}

TEST(CreepJump, MeetsTheStateThatRepeatsOfOneRate) {
  const PronyBody slow = prony(1, {0.5}, {1000});
  CreepJump jump(slow, mu, 1);
  EXPECT_TRUE(std::isinf(jump.to_come()));
  constexpr double rate = 1e-3;
  double size = 1;
  for (int k = 0; k < 4; ++k) {
    SpringState state = scaled(size);
    jump.after_period(state);
    EXPECT_EQ(state.normal_depth[1], 0);
    if (k == 3) {
      EXPECT_NEAR(state.normal_depth[0], 0, 1e-9);
      EXPECT_NEAR(state.normal_load[0], 1, 1e-9);
    }
    size *= 1 - rate;
  }
}

TEST(CreepJump, LeavesBodiesAloneThatRepeatSoon) {
  for (const auto& body : {elastic(1), standard_solid(1, 1, 10), kelvin_voigt(1, 1e6)}) {
    CreepJump jump(body, mu, 1);
    EXPECT_EQ(jump.to_come(), 0);
    SpringState state = scaled(1);
    for (int k = 0; k < 20; ++k) jump.after_period(state);
    EXPECT_EQ(state.normal_depth[0], 1);
  }
}

TEST(CreepJump, KnowsForHowLongABodyCreeps) {
  EXPECT_EQ(creep_periods(elastic(2), 1), 0);
  EXPECT_NEAR(creep_periods(prony(2, {1, 3}, {10, 20}), 0.5), (20 + 5 + 30) / 0.5, 1e-12);
  SpringState state = scaled(1);
  CreepJump jump(prony(1, {1}, {1e8}), mu, 1);
  EXPECT_THROW(jump.after_period(state), std::runtime_error);
}

/// Springs under a parabola that lifts off and slips at its rim, in the periods after a ramp of ten.
class Oscillation {
 public:
  explicit Oscillation(const PronyBody& body)
      : bed_(spring_bed(parabola(1), std::sqrt(1.1), 60)),
        step_(body, mu, 1.0 / n_steps),
        jump_(body, mu, 1),
        state_(relaxed_state(bed_, body, 1)) {}

  /// Returns the mean of the tangential loads over the period, which slip has locked in.
  double period(bool jumps) {
    const SpringState start = state_;
    double mean = 0;
    for (int j = 1; j <= n_steps; ++j) {
      const double angle = 2 * pi * j / n_steps,
                   share = std::min(1.0, (n_periods_ + static_cast<double>(j) / n_steps) / 10);
      step_.advance(state_, bed_, {1 + 0.1 * share * std::cos(angle), 0, 0.16 * share * std::cos(angle + 1), 0});
      mean += (bed_.width * state_.tangential_load).sum() / n_steps;
    }
    ++n_periods_;
    change = change_of_tractions(start, state_, mu);
    if (jumps && n_periods_ > 10) jump_.after_period(state_);
    return mean;
  }

  double change = 0;
  [[nodiscard]] double to_come() const { return jump_.to_come(); }

 private:
  static constexpr int n_steps = 60;
  SpringBed bed_;
  SpringStep step_;
  CreepJump jump_;
  SpringState state_;
  int n_periods_ = 0;
};

// What is locked in depends on the way: jumps that went too far would change it.
TEST(CreepJump, LocksInWhatPlainPeriodsDo) {
  const PronyBody body = prony(1, {0.5, 0.5}, {0.1, 250});
  Oscillation plain(body), jumping(body);
  double exact = 0, found = 0;
  for (int k = 0; k < 10'000; ++k) exact = plain.period(false);
  int n = 0;
  while (n < 200 && !(std::max(jumping.change, jumping.to_come()) < 1e-10 && n > 10)) {
    found = jumping.period(true);
    ++n;
  }
  EXPECT_LT(n, 150);
  EXPECT_NEAR(found / exact, 1, 1e-6);

  Oscillation without(body);
  for (int k = 0; k < 150; ++k) without.period(false);
  EXPECT_GT(without.change, 1e-8);
}

}  // namespace
}  // namespace fretval::mdr::creep_jump_test
