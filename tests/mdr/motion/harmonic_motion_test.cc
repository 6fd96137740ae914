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
