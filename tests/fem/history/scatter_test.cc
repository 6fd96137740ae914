#include "fem/history/scatter.h"

#include <gtest/gtest.h>

#include <array>

namespace fretval::fem {
namespace {

/// 200: never.
int periods_until_scatter(double (*change)(int period)) {
  Scatter scatter;
  int n = 1;
  while (n < 200 && !scatter.is_all(change(n))) ++n;
  return n;
}

TEST(Scatter, IsWhatRecursAndIsSmall) {
  EXPECT_EQ(periods_until_scatter([](int n) {
              return std::array{4e-3, 4e-3, 8e-5}[static_cast<std::size_t>(n) % 3];
            }),
            12);  // the least one is the second, and a change of the same size does not fall
  EXPECT_EQ(periods_until_scatter([](int) { return 9e-3; }), 11);
  EXPECT_EQ(periods_until_scatter([](int) { return 1.1e-2; }), 200);
  EXPECT_EQ(periods_until_scatter([](int n) { return 1e-3 / n; }), 200);
}

}  // namespace
}  // namespace fretval::fem
