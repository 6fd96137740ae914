#include "comparison/case/oscillations.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fretval::oscillations_test {
namespace {

Case::Motion motion_of_four() {
  Case::Motion motion;
  motion.normal_amplitude = 1e-6;
  motion.normal_frequency = 2;
  motion.tangential_amplitude = 3e-6;
  motion.tangential_frequency = 5;
  motion.phase = 30;
  motion.normal_harmonics = {{4e-7, 6, 10}};
  motion.transverse = {{2e-6, 7, 90}};
  return motion;
}

TEST(Oscillations, AreThoseOfAllDirections) {
  const auto all = oscillations_of(motion_of_four());
  ASSERT_EQ(all.size(), 4U);
  EXPECT_EQ(all[0].amplitude, 1e-6);
  EXPECT_EQ(all[1].frequency, 5);
  EXPECT_EQ(all[1].phase, 30);
  EXPECT_EQ(all[2].phase, 10);
  EXPECT_EQ(all[3].amplitude, 2e-6);
}

TEST(Oscillations, OfForcesHaveTheirAmplitudes) {
  auto motion = motion_of_four();
  motion.normal_force = Case::NormalForce{3, 0.5};
  motion.tangential_force = 0.25;
  EXPECT_EQ(oscillations_of(motion)[0].amplitude, 0.5);
  EXPECT_EQ(oscillations_of(motion)[1].amplitude, 0.25);
}

TEST(MovingFrequencies, LeaveOutWhatStandsStill) {
  auto motion = motion_of_four();
  motion.normal_amplitude = 0;
  EXPECT_EQ(moving_frequencies(motion), (std::vector<double>{5, 6, 7}));
  motion.tangential_amplitude = std::nan("");  // the one that shakes down, which is found later
  EXPECT_EQ(moving_frequencies(motion), (std::vector<double>{5, 6, 7}));
}

TEST(MovingFrequencies, OfAPathAreThoseOfItsPeriod) {
  auto motion = motion_of_four();
  motion.path = Case::Path{};
  motion.path->time = {1, 1.5, 1.75};
  motion.path->repeats = true;
  EXPECT_EQ(moving_frequencies(motion), (std::vector<double>{1 / 0.75}));
  motion.path->repeats = false;
  EXPECT_TRUE(moving_frequencies(motion).empty());
  EXPECT_TRUE(oscillations_of(motion).empty());
}

}  // namespace
}  // namespace fretval::oscillations_test
