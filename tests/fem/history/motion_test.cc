#include "fem/history/motion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fem/support/constants.h"

namespace fretval::fem::motion_test {
namespace {

Motion locked() {
  return {0.8, 0.2, 0.3, 0.7, 3};
}

Motion unlocked() {
  return {0.8, 0.2, 0.3, {}, 3, 12};
}

// Central difference: h^2/6 = 2e-11 of the third derivative, and roundoff of t = 80 over h, 1e-14/1e-5 = 1e-9.
TEST(Motion, RatesAreDerivatives) {
  const double h = 1e-5;
  for (const auto& motion : {locked(), unlocked()})
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

TEST(Motion, PeriodIsOneCycleOrTheCreep) {
  EXPECT_EQ(locked().cycles_per_period(), 1);
  EXPECT_EQ(unlocked().cycles_per_period(), 12);
}

}  // namespace
}  // namespace fretval::fem::motion_test
