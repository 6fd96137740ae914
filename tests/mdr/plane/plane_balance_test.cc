#include "mdr/plane/plane_balance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace fretval::mdr {
namespace {

using Eigen::ArrayXd;
using Eigen::Vector2d;

TEST(PlaneBalance, KeepsToTheLimit) {
  ArrayXd most(3), x(3), y(3);
  most << 1, 1, 0;
  x << 0.3, 3, 1;
  y << 0.4, 4, 1;
  const ArrayXd kept = shares_within(most, x, y);
  EXPECT_EQ(kept[0], 1);
  EXPECT_NEAR(kept[1], 0.2, 1e-15);
  EXPECT_EQ(kept[2], 0);
}

// One spring: it goes by the lack of its load; nothing else sticks or slips.
TEST(PlaneBalance, OfOneSpringIsItsStiffness) {
  const PlaneLines lines{ArrayXd::Constant(1, 0.5), ArrayXd::Constant(1, 0.1), ArrayXd::Constant(1, -0.2),
                         ArrayXd::Constant(1, 2), 4};
  const auto u = way_for_forces({0.45, 0.1}, lines);
  EXPECT_NEAR(u[0], 0.2, 1e-13);
  EXPECT_NEAR(u[1], 0.1, 1e-13);
}

// Whatever they bear before, and however near to sliding: the sum is what it has to be.
TEST(PlaneBalance, BearsTheSum) {
  std::mt19937 random(1);
  const auto any = [&](double from, double to) { return std::uniform_real_distribution<double>(from, to)(random); };
  for (int problem = 0; problem < 100; ++problem) {
    const auto field = [&](double from, double to) {
      return ArrayXd(ArrayXd::NullaryExpr(20, [&] { return any(from, to); }));
    };
    const PlaneLines lines{field(0.5, 1), field(-1, 1), field(-1, 1), field(0, 1), any(0.1, 10)};
    const double share = 1 - std::pow(10, any(-6, -0.3)), angle = any(0, 6.28),
                 size = share * (lines.width * lines.most).sum();
    const Vector2d sum(size * std::cos(angle), size * std::sin(angle)), u = way_for_forces(sum, lines);
    const ArrayXd x = lines.x + lines.stiffness * u[0], y = lines.y + lines.stiffness * u[1],
                  kept = shares_within(lines.most, x, y);
    EXPECT_NEAR((lines.width * kept * x).sum(), sum[0], 1e-10) << share;
    EXPECT_NEAR((lines.width * kept * y).sum(), sum[1], 1e-10) << share;
  }
}

}  // namespace
}  // namespace fretval::mdr
