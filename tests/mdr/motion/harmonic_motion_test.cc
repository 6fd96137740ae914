#include "mdr/motion/harmonic_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "mdr/support/constants.h"

namespace fretval::mdr::harmonic_motion_test {
namespace {

// Guarantee of the maximum, for amplitudes of order one.
constexpr double tolerance = 2e-13;

TEST(HarmonicMotion, ExtremesOfTheIndentation) {
  const HarmonicMotion motion{2, {{1, 3, 0}, {1, 6, pi}}, {{5, 1, 0}}};
  EXPECT_NEAR(maximum_indentation(motion), 3.125, tolerance);
  // x + 1 - 2 x^2 at x = -1.
  EXPECT_NEAR(minimum_indentation(motion), 0, tolerance);
  EXPECT_EQ(maximum_indentation(HarmonicMotion{2, {}, {}}), 2);
}

TEST(HarmonicMotion, FromMotion) {
  const Motion motion{1, 0.2, 0.3, 2, 5, 0.7};
  EXPECT_NEAR(maximum_indentation(harmonic_motion(motion)), maximum_indentation(motion), tolerance);
  EXPECT_TRUE(harmonic_motion(motion).phase_locked);
  EXPECT_EQ(harmonic_motion(motion).tangential[0].phase, 0.7);
  EXPECT_EQ(harmonic_motion(motion).tangential[0].frequency, 5);
  EXPECT_FALSE(harmonic_motion({1, 0.2, 0.3, 2, 5, std::nullopt}).phase_locked);
}

TEST(HarmonicMotion, BackToMotion) {
  const Motion motion{1, 0.2, 0.3, 2, 5, 0.7};
  auto harmonic = harmonic_motion(motion);
  harmonic.normal.push_back({0, 7, 1});  // does not move
  const auto back = one_harmonic_each(harmonic).value();
  EXPECT_EQ(back.indentation, 1);
  EXPECT_EQ(back.normal_amplitude, 0.2);
  EXPECT_EQ(back.tangential_amplitude, 0.3);
  EXPECT_EQ(back.normal_frequency, 2);
  EXPECT_EQ(back.tangential_frequency, 5);
  EXPECT_EQ(back.phase, 0.7);
  harmonic.phase_locked = false;
  EXPECT_FALSE(one_harmonic_each(harmonic)->phase);
  harmonic.normal[0].phase = 0.1;
  EXPECT_FALSE(one_harmonic_each(harmonic)) << "not deepest at time 0";
  harmonic.normal = {{0.2, 2, 0}, {0.1, 4, 0}};
  EXPECT_FALSE(one_harmonic_each(harmonic));
}

// 2 Hz and 3 Hz repeat every second, 1.5 and 2.5 Hz every two; what does not move counts for nothing.
TEST(HarmonicMotion, CommonCycle) {
  const auto cycle = common_cycle({1, {{0.1, 2, 0}}, {{0.1, 3, 0}}}).value();
  EXPECT_DOUBLE_EQ(cycle.frequency, 1);
  EXPECT_EQ(cycle.normal_orders, std::vector<int>{2});
  EXPECT_EQ(cycle.tangential_orders, std::vector<int>{3});
  EXPECT_EQ(cycle.highest_order(), 3);
  const auto longer = common_cycle({1, {{0.1, 1.5, 0}, {0, std::sqrt(2), 0}}, {{0.1, 2.5, 0}}}).value();
  EXPECT_DOUBLE_EQ(longer.frequency, 0.5);
  EXPECT_EQ(longer.normal_orders, (std::vector<int>{3, 0}));
  EXPECT_EQ(longer.tangential_orders, std::vector<int>{5});
  EXPECT_FALSE(common_cycle({1, {{0.1, 1, 0}}, {{0.1, std::sqrt(2), 0}}}));
  EXPECT_EQ(common_cycle({1, {{0, 7, 0}}, {{0, 3, 0}}})->frequency, 7) << "nothing moves";
}

TEST(HarmonicMotion, HasGroupsOfCommensurateHarmonics) {
  const double root = std::sqrt(2);
  const auto mixed = harmonic_groups({1, {{0.1, 2, 0}, {0.1, root, 0}}, {{0, 7, 0}, {0.1, 3, 0}, {0.1, 2 * root, 0}}});
  ASSERT_EQ(mixed.size(), 2U);
  EXPECT_DOUBLE_EQ(mixed[0].base_frequency, 1);
  ASSERT_EQ(mixed[0].members.size(), 2U);
  EXPECT_TRUE(mixed[0].members[0].normal);
  EXPECT_FALSE(mixed[0].members[1].normal);
  EXPECT_EQ(mixed[0].members[1].place, 1U) << "the first one does not move";
  EXPECT_EQ(mixed[0].members[1].order, 3);
  EXPECT_EQ(mixed[0].highest_order(), 3);
  EXPECT_FALSE(are_the_directions(mixed));
  EXPECT_TRUE(are_the_directions(harmonic_groups({1, {{0.1, 1, 0}, {0.1, 2, 0}}, {{0.1, root, 0}}})));
  EXPECT_FALSE(are_the_directions(harmonic_groups({1, {{0, 1, 0}}, {{0.1, 1, 0}, {0.1, root, 0}}})));
  EXPECT_TRUE(harmonic_groups({1, {{0, 1, 0}}, {{0, 1, 0}}}).empty());
}

// cos(3 w t) + cos(6 w t + pi) is largest where cos(3 w t) = 1/4.
TEST(HarmonicMotion, BeginsAtTheLargestIndentation) {
  const auto later = from_largest_indentation({2, {{1, 3, 0}, {1, 6, pi}}, {{0.5, 1, 0.2}}});
  const double angle = later.normal[0].phase;
  EXPECT_NEAR(std::cos(angle), 0.25, 1e-9);
  EXPECT_NEAR(std::cos(angle) + std::cos(later.normal[1].phase), 1.125, tolerance);
  EXPECT_NEAR(later.tangential[0].phase, 0.2 + angle / 3, tolerance) << "at the first of three such instants";
  EXPECT_EQ(from_largest_indentation({2, {{1, 3, 0}}, {{1, 2, 0.3}}}).tangential[0].phase, 0.3);
  EXPECT_NEAR(from_largest_indentation({2, {{1, 0.5, -pi / 2}}, {}}).normal[0].phase, 0, 1e-12);
}

// Two normal harmonics that never are largest together begin as if they were, each with the tangential ones that are
// tied to it.
TEST(HarmonicMotion, WithoutACommonPeriodBeginsAtTheSupremum) {
  const auto motion = from_largest_indentation(
      {2, {{1, 1, -pi / 2}, {1, std::sqrt(2), -pi / 3}}, {{1, 2, 0}, {1, 2 * std::sqrt(2), 0}, {1, pi, 0.7}}});
  EXPECT_NEAR(motion.normal[0].phase, 0, 1e-12);
  EXPECT_NEAR(motion.normal[1].phase, 0, 1e-12);
  EXPECT_NEAR(motion.tangential[0].phase, pi, 1e-12);
  EXPECT_NEAR(motion.tangential[1].phase, 2 * pi / 3, 1e-12);
  EXPECT_EQ(motion.tangential[2].phase, 0.7);
}

TEST(HarmonicMotion, RejectsBadMotions) {
  EXPECT_THROW(validate(HarmonicMotion{0, {}, {}}), std::invalid_argument);
  EXPECT_THROW(validate(HarmonicMotion{1, {{-1, 1, 0}}, {}}), std::invalid_argument);
  EXPECT_THROW(validate(HarmonicMotion{1, {}, {{1, 0, 0}}}), std::invalid_argument);
  try {
    validate(HarmonicMotion{1, {}, {{1, 1, 0}, {1, 1, NAN}}});
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "phase of tangential harmonic 2 = nan: must be finite");
  }
}

}  // namespace
}  // namespace fretval::mdr::harmonic_motion_test
