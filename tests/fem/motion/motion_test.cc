#include "fem/motion/motion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fem/support/constants.h"

namespace fretval::fem::motion_test {
namespace {

Motion locked() {
  auto motion = one_frequency(0.8, 0.2, 0.3, 0.7);
  motion.n_ramp_cycles = 3;
  return motion;
}

Motion unlocked() {
  auto motion = one_frequency(0.8, 0.2, 0.3, {});
  motion.n_ramp_cycles = 3;
  motion.n_creep_cycles = 12;
  return motion;
}

/// Two normal and two tangential oscillations of orders 2, 3, 3 and 5.
Motion several() {
  return {0.8, {{0.1, 2, 0.4}, {0.05, 3, 0}}, {{0.2, 3, 0.7}, {0.1, 5, -0.3}}, true, 4, 60};
}

Motion several_unlocked() {
  auto motion = several();
  motion.locked = false;
  return motion;
}

// Central difference: h^2/6 = 2e-11 of the third derivative, and roundoff of t = 80 over h, 1e-14/1e-5 = 1e-9.
TEST(Motion, RatesAreDerivatives) {
  const double h = 1e-5;
  for (const auto& motion : {locked(), unlocked(), several(), several_unlocked()})
    for (const auto& part : {normal_motion, tangential_motion})
      for (int k = 0; k < 216; ++k) {
        const double t = 0.1 + 0.37 * k;
        const double difference = (part(motion, t + h).value - part(motion, t - h).value) / (2 * h);
        EXPECT_NEAR(part(motion, t).rate, difference, 1e-9) << "t = " << t;
      }
}

TEST(Motion, StartsAtRestAtTheMeanIndentation) {
  for (const auto& motion : {locked(), unlocked()}) {
    EXPECT_EQ(normal_motion(motion, 0).value, 0.8);
    EXPECT_EQ(normal_motion(motion, 0).rate, 0);
    EXPECT_EQ(tangential_motion(motion, 0).value, 0);
    EXPECT_EQ(tangential_motion(motion, 0).rate, 0);
  }
}

TEST(Motion, IsHarmonicAfterTheRamp) {
  for (int k = 0; k < 60; ++k) {
    const double t = 6 * pi + 0.1 * k;
    EXPECT_DOUBLE_EQ(normal_motion(locked(), t).value, 0.8 + 0.2 * std::cos(t));
    EXPECT_DOUBLE_EQ(tangential_motion(locked(), t).value, 0.3 * std::cos(t + 0.7));
  }
}

TEST(Motion, RampNeverExceedsTheFullAmplitude) {
  for (int k = 0; k < 1880; ++k) {
    const double t = 0.01 * k;
    EXPECT_LE(std::abs(normal_motion(locked(), t).value - 0.8), 0.2 * std::abs(std::cos(t)) + 1e-15);
    EXPECT_LE(std::abs(tangential_motion(locked(), t).value), 0.3);
  }
}

TEST(Motion, UnlockedPhaseCreepsThereAndBackWithinThePeriod) {
  const Motion motion = unlocked();
  const double half = pi * motion.n_creep_cycles, begin = 2 * half;
  // At the whole period the phase is 0, at half of it pi; both are at rest there, so the motion is harmonic nearby.
  for (const double dt : {-0.05, 0.0, 0.05}) {
    EXPECT_NEAR(tangential_motion(motion, begin + dt).value, 0.3 * std::cos(dt), 1e-4);
    EXPECT_NEAR(tangential_motion(motion, begin + half + dt).value, -0.3 * std::cos(half + dt), 1e-4);
    EXPECT_NEAR(tangential_motion(motion, begin + dt).value, tangential_motion(motion, 2 * begin + dt).value, 1e-13);
  }
}

TEST(Motion, IsTheSumOfItsOscillationsAfterTheRampOfTheSlowest) {
  const Motion motion = several();
  EXPECT_EQ(motion.cycles_of_ramp(), 2);
  EXPECT_EQ(motion.highest_order(), 5);
  EXPECT_EQ(motion.highest_normal_order(), 3);
  EXPECT_DOUBLE_EQ(motion.tangential_amplitude(), 0.3);
  for (int k = 0; k < 60; ++k) {
    const double t = 4 * pi + 0.1 * k;
    EXPECT_NEAR(normal_motion(motion, t).value, 0.8 + 0.1 * std::cos(2 * t + 0.4) + 0.05 * std::cos(3 * t), 1e-14);
    EXPECT_NEAR(tangential_motion(motion, t).value, 0.2 * std::cos(3 * t + 0.7) + 0.1 * std::cos(5 * t - 0.3), 1e-14);
  }
}

// Half way through its period the tangential motion is ahead by as many lags as differ. Orders 2 and 3 repeat once a
// cycle, as do 3 and 5: a whole cycle ahead; 2 and 4 against 3: a sixth of it.
TEST(Motion, UnlockedOscillationsPassThroughAllLags) {
  auto motion = several_unlocked();
  EXPECT_EQ(motion.cycles_per_period(), 30);
  const auto expect_ahead = [&](double lag) {
    auto locked = motion;
    locked.locked = true;
    for (const double dt : {-0.05, 0.0, 0.05}) {
      const double t = 3 * pi * motion.cycles_per_period() + dt;
      EXPECT_NEAR(tangential_motion(motion, t).value, tangential_motion(locked, t + lag).value, 1e-3);
      EXPECT_GT(std::abs(tangential_motion(motion, t / 2).value - tangential_motion(locked, t / 2).value), 1e-3);
    }
  };
  expect_ahead(2 * pi);
  motion.normal[1].order = 4;
  motion.tangential.resize(1);
  expect_ahead(2 * pi / 6);
  motion = unlocked();
  expect_ahead(pi);
  motion.normal_force = true;
  expect_ahead(2 * pi);
}

TEST(Motion, PeriodIsOneCycleOrTheCreep) {
  EXPECT_EQ(locked().cycles_per_period(), 1);
  EXPECT_EQ(unlocked().cycles_per_period(), 12);
  EXPECT_EQ(creep_period(48, 3), 24);
  for (const int order : {4, 14}) EXPECT_EQ(creep_period(48, order), 2 * creep_period(24, order));
}

TEST(Motion, MovesAcrossIfAnyOfItsOscillationsDoes) {
  auto motion = one_frequency(0.8, 0.2, 0.3, 0.7);
  EXPECT_FALSE(motion.moves_across());
  motion.tangential.push_back({0.1, 2, 0, true});
  EXPECT_TRUE(motion.moves_across());
  motion.tangential.clear();
  EXPECT_FALSE(motion.moves_across());
}

}  // namespace
}  // namespace fretval::fem::motion_test
