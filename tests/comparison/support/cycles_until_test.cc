#include "comparison/support/cycles_until.h"

#include <gtest/gtest.h>

namespace fretval::cycles_until_test {
namespace {

TEST(CyclesUntil, AreWhereALineBetweenTwoCyclesCrossesForTheLastTime) {
  EXPECT_DOUBLE_EQ(cycles_until({4, 3, 1}, 1.5).value(), 2.75);
  EXPECT_DOUBLE_EQ(cycles_until({0, 5, 0, 2, 0, 0}, 1).value(), 4.5);
  EXPECT_DOUBLE_EQ(cycles_until({2, 1}, 1).value(), 2);
}

TEST(CyclesUntil, AreNoneWhereNothingSlipsOrSlipHasNotEnded) {
  EXPECT_FALSE(cycles_until({}, 1));
  EXPECT_FALSE(cycles_until({0.5, 1, 0}, 1));
  EXPECT_FALSE(cycles_until({0, 3, 2}, 1));
}

}  // namespace
}  // namespace fretval::cycles_until_test
