#include "mdr/motion/commensurability.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <stdexcept>

#include "mdr/support/constants.h"

namespace fretval::mdr::commensurability_test {
namespace {

void expect_ratio(double ratio, int numerator, int denominator) {
  const auto found = frequency_ratio(ratio);
  ASSERT_TRUE(found) << ratio;
  EXPECT_EQ(found->numerator, numerator);
  EXPECT_EQ(found->denominator, denominator);
}

TEST(FrequencyRatio, SeesThroughRoundoff) {
  expect_ratio(1, 1, 1);
  expect_ratio(1.0 / 3, 1, 3);
  expect_ratio((0.1 + 0.2) / 0.3, 1, 1);
  expect_ratio(0.6 / 0.2, 3, 1);
  expect_ratio((2 * pi * 3) / (2 * pi * 7), 3, 7);
  expect_ratio(0.3333333333333, 1, 3);
}

TEST(FrequencyRatio, FindsEveryFractionUpToTheBound) {
  for (int p = 1; p <= largest_order; p += 97) {
    for (int q = 1; q <= largest_order; q += 89) {
      const int divisor = std::gcd(p, q);
      expect_ratio(double(p) / q, p / divisor, q / divisor);
    }
  }
  expect_ratio(largest_order, largest_order, 1);
  expect_ratio(1.0 / largest_order, 1, largest_order);
}

TEST(FrequencyRatio, RefusesIrrationalAndLargeOnes) {
  for (const double ratio : {std::sqrt(2.0), (1 + std::sqrt(5.0)) / 2, pi, std::exp(1.0), 10001.0, 1e-5, 1 + 1e-9,
                             10001.0 / 10003, 1e300, 1e-300}) {
    EXPECT_FALSE(frequency_ratio(ratio)) << ratio;
  }
  EXPECT_THROW(frequency_ratio(0), std::invalid_argument);
  EXPECT_THROW(frequency_ratio(NAN), std::invalid_argument);
}

TEST(CommensurateGroups, SplitByIrrationalRatios) {
  const double root = std::sqrt(2.0);
  const auto groups = commensurate_groups({1, 2 * root, 3, root, 1.5});
  ASSERT_EQ(groups.size(), 2u);
  EXPECT_EQ(groups[0].members, (std::vector<std::size_t>{0, 2, 4}));
  EXPECT_EQ(groups[0].orders, (std::vector<int>{2, 6, 3}));
  EXPECT_DOUBLE_EQ(groups[0].base_frequency, 0.5);
  EXPECT_EQ(groups[1].members, (std::vector<std::size_t>{1, 3}));
  EXPECT_EQ(groups[1].orders, (std::vector<int>{2, 1}));
  EXPECT_DOUBLE_EQ(groups[1].base_frequency, root);
}

TEST(CommensurateGroups, RefineTheBaseFrequency) {
  const auto groups = commensurate_groups({1.0 / 2, 1.0 / 3, 1.0 / 5});
  ASSERT_EQ(groups.size(), 1u);
  EXPECT_EQ(groups[0].orders, (std::vector<int>{15, 10, 6}));
  EXPECT_NEAR(groups[0].base_frequency, 1.0 / 30, 1e-16);
}

TEST(CommensurateGroups, KeepOrdersBelowTheBound) {
  const auto groups = commensurate_groups({1, 1.0 / 97, 1.0 / 101, 1.0 / 103});
  ASSERT_EQ(groups.size(), 2u);
  EXPECT_EQ(groups[0].orders, (std::vector<int>{97 * 101, 101, 97}));
  EXPECT_EQ(groups[1].members, (std::vector<std::size_t>{3}));
}

TEST(CommensurateGroups, OfNothingAndOfBadFrequencies) {
  EXPECT_TRUE(commensurate_groups({}).empty());
  EXPECT_THROW(commensurate_groups({1, -1}), std::invalid_argument);
}

}  // namespace
}  // namespace fretval::mdr::commensurability_test
