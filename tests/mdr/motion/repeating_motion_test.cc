#include "mdr/motion/repeating_motion.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fretval::mdr::repeating_motion_test {
namespace {

const double pi = std::acos(-1.0), golden = (1 + std::sqrt(5)) / 2;

HarmonicMotion with_ratio(double ratio) {
  return {1, {{0.1, 2, 0}}, {{0.2, 2 * ratio, 0.3}}};
}

TEST(RepeatingMotion, OfACommonPeriodIsTheMotionItself) {
  EXPECT_DOUBLE_EQ(repeating_motion(with_ratio(1), 48).period(), 0.5);
  EXPECT_DOUBLE_EQ(repeating_motion(with_ratio(1.5), 48).period(), 1);
  const auto several = repeating_motion({1, {{0.1, 0.4, 0}, {0.1, 1, 0}}, {{0.1, 0.6, 0.3}}}, 48);
  EXPECT_DOUBLE_EQ(several.period(), 5);
  EXPECT_EQ(several.motion.tangential[0].phase, 0.3);
  EXPECT_EQ(several.lag_at(1.7), 0);
  EXPECT_EQ(several.periods_with(20), 20) << "a ramp of twenty periods";
}

// There and back through a whole turn, which for 2:3 is a sixth of the cycle.
TEST(RepeatingMotion, OfAnUnlockedPhaseCreepsThroughAllLags) {
  auto motion = with_ratio(1.5);
  motion.phase_locked = false;
  const auto repeating = repeating_motion(motion, 48);
  EXPECT_EQ(repeating.n_cycles, 16) << "48 oscillations of the faster one";
  EXPECT_DOUBLE_EQ(repeating.period(), 16);
  EXPECT_EQ(repeating.lag_at(0), 0);
  EXPECT_NEAR(repeating.lag_at(8), 1.0 / 6, 1e-15);
  EXPECT_NEAR(repeating.lag_at(16), 0, 1e-15);
  const double step = 1e-5;
  EXPECT_NEAR(repeating.lag_rate_at(3), (repeating.lag_at(3 + step) - repeating.lag_at(3 - step)) / (2 * step), 1e-9);
  EXPECT_EQ(repeating.periods_with(20), 1) << "of 32 oscillations of the slower one";
}

TEST(RepeatingMotion, OfTheGoldenRatioIsAConvergent) {
  const auto repeating = repeating_motion(with_ratio(golden), 96);
  EXPECT_DOUBLE_EQ(repeating.period(), 55 / 2.0);
  EXPECT_EQ(repeating.motion.normal[0].frequency, 2);
  EXPECT_DOUBLE_EQ(repeating.motion.tangential[0].frequency, 2 * 89 / 55.0);
  EXPECT_EQ(repeating.lag, 0);
  EXPECT_TRUE(repeating.motion.phase_locked);
}

// Two generators that drift apart.
TEST(RepeatingMotion, OfNearlyEqualFrequenciesCreeps) {
  const auto repeating = repeating_motion(with_ratio(1.00001), 48);
  EXPECT_DOUBLE_EQ(repeating.motion.tangential[0].frequency, 2);
  EXPECT_EQ(repeating.n_cycles, 48);
  EXPECT_DOUBLE_EQ(repeating.lag, 0.5);
}

// The tangential motion has the frequency of the second normal harmonic, and keeps it.
TEST(RepeatingMotion, KeepsCommensurateHarmonicsTogether) {
  const auto repeating =
      repeating_motion({1, {{0.1, 1, 0}, {0.1, std::sqrt(2), 0}}, {{0.1, 2 * std::sqrt(2), 0.4}}}, 48);
  EXPECT_EQ(repeating.motion.normal[0].frequency, 1);
  EXPECT_DOUBLE_EQ(repeating.motion.normal[1].frequency, 24 / 17.0);
  EXPECT_DOUBLE_EQ(repeating.motion.tangential[0].frequency, 2 * repeating.motion.normal[1].frequency);
  EXPECT_EQ(repeating.motion.tangential[0].phase, 0.4);
  EXPECT_EQ(repeating.lag, 0);
}

TEST(RepeatingMotion, RejectsBadMotions) {
  EXPECT_THROW(repeating_motion({0, {{1, 1, 0}}, {}}, 48), std::invalid_argument);
  EXPECT_THROW(repeating_motion(with_ratio(golden), 0), std::invalid_argument);
}

}  // namespace
}  // namespace fretval::mdr::repeating_motion_test
