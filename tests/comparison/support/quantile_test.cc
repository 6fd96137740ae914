#include "comparison/support/quantile.h"

#include <gtest/gtest.h>

namespace fretval {
namespace {

TEST(Quantile, IsTheNearestRank) {
  EXPECT_FALSE(quantile({}, 0.5));
  EXPECT_EQ(quantile({3, 1, 2}, 0.5), 2);
  EXPECT_EQ(quantile({3, 1, 2}, 1), 3);
  EXPECT_EQ(quantile({3, 1, 2}, 0), 1);
}

}  // namespace
}  // namespace fretval
