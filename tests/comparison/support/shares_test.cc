#include "comparison/support/shares.h"

#include <gtest/gtest.h>

#include <set>

namespace fretval::shares_test {
namespace {

TEST(Shares, HandOutEachNumberOnce) {
  for (const std::size_t n : {0, 1, 2, 7, 100})
    for (const std::size_t n_ranks : {1, 2, 3, 8}) {
      Shares shares(n, n_ranks);
      std::set<std::size_t> given;
      for (std::size_t asked = 0; asked < n; ++asked)
        EXPECT_TRUE(given.insert(shares.next(asked * asked % n_ranks, asked % 3 == 0).value()).second);
      EXPECT_EQ(given.size(), n);
      for (std::size_t rank = 0; rank < n_ranks; ++rank) EXPECT_FALSE(shares.next(rank, true));
    }
}

TEST(Shares, AreStretchesThatTwoThreadsTakeFromBothEnds) {
  Shares shares(10, 2);
  EXPECT_EQ(shares.next(0, true), 0U);
  EXPECT_EQ(shares.next(0, false), 4U);
  EXPECT_EQ(shares.next(1, true), 5U);
  EXPECT_EQ(shares.next(1, true), 6U);
  EXPECT_EQ(shares.next(0, true), 1U);
}

// One rank alone does it all: where the others have most left, and from the end that they come to last.
TEST(Shares, GoToWhoIsDoneWithHisOwn) {
  Shares shares(9, 3);
  EXPECT_EQ(shares.next(1, true), 3U);
  for (const std::size_t expected : {0, 1, 2, 8}) EXPECT_EQ(shares.next(0, true), expected);
  Shares two(6, 2);
  for (const std::size_t expected : {0, 1, 2, 5, 4}) EXPECT_EQ(two.next(0, true), expected);
  EXPECT_EQ(two.next(1, true), 3U);
}

}  // namespace
}  // namespace fretval::shares_test
