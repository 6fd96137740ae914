#include "mdr/support/wide_registers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace fretval::mdr {
namespace {

double some_sum(double x, double y) {
  return std::max(x * y + 1 / (1 + y), x - y * y);
}

// A fused operation would differ in the last bit of one of them.
TEST(WideRegisters, ChangeNoBit) {
  constexpr std::size_t n = 1003;
  std::vector<double> x(n), y(n), wide(n);
  for (std::size_t i = 0; i < n; ++i) {
    x[i] = std::sin(static_cast<double>(i));
    y[i] = std::cos(0.7 * static_cast<double>(i)) / 3;
  }
  in_wide_registers([&] {
    for (std::size_t i = 0; i < n; ++i) wide[i] = some_sum(x[i], y[i]);
  });
  for (std::size_t i = 0; i < n; ++i) EXPECT_EQ(wide[i], some_sum(x[i], y[i])) << i;
}

}  // namespace
}  // namespace fretval::mdr
