#include "mdr/motion/motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace fretval::mdr::motion_test {
namespace {

TEST(Motion, MaximumIndentationIsPaper12) {
  EXPECT_EQ(maximum_indentation({0.25, 0.5, 0, 1, 1, 0.0}), 0.75);
}

TEST(Motion, AngularFrequencyTurnsOncePerCycle) {
  EXPECT_NEAR(std::cos(angular_frequency(3) / 3), 1, 1e-15);
}

TEST(Motion, RejectsBadMotions) {
  EXPECT_NO_THROW(validate(Motion{1, 0, 0, 1, 2, std::nullopt}));
  EXPECT_THROW(validate(Motion{0, 0, 0, 1, 1, 0.0}), std::invalid_argument);
  EXPECT_THROW(validate(Motion{1, -1, 0, 1, 1, 0.0}), std::invalid_argument);
  EXPECT_THROW(validate(Motion{1, 0, -1, 1, 1, 0.0}), std::invalid_argument);
  EXPECT_THROW(validate(Motion{1, 0, 0, 0, 1, 0.0}), std::invalid_argument);
  EXPECT_THROW(validate(Motion{1, 0, 0, 1, INFINITY, 0.0}), std::invalid_argument);
  EXPECT_THROW(validate(Motion{1, 0, 0, 1, 1, NAN}), std::invalid_argument);
}

TEST(Motion, MessageNamesQuantityAndValue) {
  try {
    validate(Motion{-0.5, 0, 0, 1, 1, 0.0});
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "indentation = -0.5: must be finite and positive");
  }
}

}  // namespace
}  // namespace fretval::mdr::motion_test
