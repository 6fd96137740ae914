#include "comparison/support/statistics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fretval::statistics_test {
namespace {

TEST(Quantile, IsTheNearestRank) {
  EXPECT_FALSE(quantile({}, 0.5));
  EXPECT_EQ(quantile({3, 1, 2}, 0.5), 2);
  EXPECT_EQ(quantile({3, 1, 2}, 1), 3);
  EXPECT_EQ(quantile({3, 1, 2}, 0), 1);
}

TEST(LargestSize, IsTheLargestAbsoluteValue) {
  EXPECT_EQ(largest_size({1, -3, 2}), 3);
  EXPECT_EQ(largest_size({}), 0);
  EXPECT_EQ(range_of({1, -3, 2}), 5);
}

TEST(Thinned, TakesValuesAtEqualDistances) {
  EXPECT_EQ(thinned({1, 2, 3, 4, 5}, 2), (std::vector<double>{1, 4}));
  EXPECT_EQ(thinned({1, 2, 3, 4, 5}, 3), (std::vector<double>{1, 3, 5}));
  EXPECT_EQ(thinned({1, 2}, 2), (std::vector<double>{1, 2}));
  EXPECT_TRUE(thinned({}, 2).empty());
}

TEST(ToDigits, RoundsToSignificantDigits) {
  EXPECT_EQ(to_digits(1234.567, 5), 1234.6);
  EXPECT_EQ(to_digits(-0.00123456, 2), -0.0012);
  EXPECT_TRUE(std::isnan(to_digits(std::nan(""), 5)));
}

TEST(LogSlope, IsTheExponentOfAPower) {
  std::vector<double> x, y;
  for (const double value : {8.0, 12.0, 16.0, 32.0, 64.0}) {
    x.push_back(value);
    y.push_back(3 * std::pow(value, -2.5));
  }
  const auto all = log_slope(x, y, 0);
  EXPECT_NEAR(all->slope, -2.5, 1e-13);
  EXPECT_EQ(all->n_points, 5);
  const auto above = log_slope(x, y, 1.01 * y[2]);  // the two largest
  EXPECT_NEAR(above->slope, -2.5, 1e-13);
  EXPECT_EQ(above->n_points, 2);
  EXPECT_FALSE(log_slope(x, y, y[1]));
  EXPECT_FALSE(log_slope({2, 2}, {1, 3}, 0));
}

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
}  // namespace fretval::statistics_test
