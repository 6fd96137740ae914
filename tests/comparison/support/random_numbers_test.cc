#include "comparison/support/random_numbers.h"

#include <gtest/gtest.h>

namespace fretval {
namespace {

TEST(RandomNumbers, AreTheSameEverywhere) {
  RandomNumbers random({1, 2, 3});
  // std::seed_seq and std::mt19937_64 by an independent program.
  std::seed_seq sequence{1, 2, 3};
  std::mt19937_64 bits(sequence);
  EXPECT_EQ(random.uniform(0, 1), static_cast<double>(bits() >> 11U) / 9007199254740992.0);
}

TEST(RandomNumbers, KeepTheirRangesAndWeights) {
  RandomNumbers random({7});
  std::vector<int> counts(3);
  for (int k = 0; k < 3000; ++k) {
    const double x = random.uniform(-2, 3), y = random.log_uniform(1e-3, 1e3);
    EXPECT_TRUE(x >= -2 && x < 3);
    EXPECT_TRUE(y >= 1e-3 * (1 - 1e-15) && y < 1e3 * (1 + 1e-12));
    EXPECT_LT(random.index(5), 5U);
    ++counts[random.weighted({1, 0, 2})];
  }
  EXPECT_EQ(counts[1], 0);
  EXPECT_NEAR(counts[2], 2000, 150);
}

}  // namespace
}  // namespace fretval
