#include "comparison/model_error/interpolated.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fretval::interpolated_test {
namespace {

std::vector<Node> nodes_of(double (*f)(double), std::size_t n, double bar = 0) {
  std::vector<Node> nodes;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = static_cast<double>(i) / static_cast<double>(n - 1);
    nodes.push_back({x, f(x), bar});
  }
  return nodes;
}

TEST(Interpolated, IsExactForACubic) {
  const auto nodes = nodes_of([](double x) { return 1 - 2 * x + x * x * x; }, 7);
  for (const double x : {0.0, 0.11, 0.52, 0.97, 1.0}) {
    const auto one = interpolated(nodes, x);
    ASSERT_TRUE(one) << x;
    EXPECT_NEAR(one->value, 1 - 2 * x + x * x * x, 1e-14) << x;
    EXPECT_NEAR(one->uncertainty, 0, 1e-14) << x;
  }
}

TEST(Interpolated, IsOffByNoMoreThanItSays) {
  const auto f = [](double x) { return std::exp(-3 * x) * std::sin(4 * x); };
  const auto nodes = nodes_of(f, 7);
  for (double x = 0; x <= 1; x += 0.013) {
    const auto one = interpolated(nodes, x);
    EXPECT_LE(std::abs(one->value - f(x)), one->uncertainty + 2e-3) << x;
  }
}

TEST(Interpolated, HasTheBarsOfItsNodes) {
  const auto nodes = nodes_of([](double x) { return x; }, 5, 0.1);
  EXPECT_NEAR(interpolated(nodes, 0.25)->uncertainty, 0.1, 1e-14);
  EXPECT_GE(interpolated(nodes, 0.4)->uncertainty, 0.1);
}

// x² through three nodes is exact, and a line through the ends off by 3/16; x³ through four of them, by 3/8 halfway.
TEST(Interpolated, IsUncertainByAThirdOfWhatEveryOtherNodeAndTheLastOneGive) {
  EXPECT_NEAR(interpolated(nodes_of([](double x) { return x * x; }, 3), 0.25)->uncertainty, 0.1875 / 3, 1e-15);
  EXPECT_NEAR(interpolated(nodes_of([](double x) { return x * x * x; }, 4), 0.5)->uncertainty, 0.375 / 3, 1e-15);
}

// Amplitudes are set, and tables are printed, to some 3e-3.
TEST(Interpolated, TakesAPlaceForTheNodeThatItIsAt) {
  const auto nodes = nodes_of([](double x) { return x * x; }, 3, 0.1);
  EXPECT_NEAR(interpolated(nodes, 0.502)->uncertainty, 0.1, 1e-3);
  EXPECT_TRUE(interpolated(nodes, -2e-3));
  EXPECT_TRUE(interpolated(nodes, 1 + 2e-3));
}

TEST(Interpolated, IsNothingOutside) {
  const auto nodes = nodes_of([](double x) { return x; }, 5);
  EXPECT_FALSE(interpolated(nodes, -0.01));
  EXPECT_FALSE(interpolated(nodes, 1.01));
  EXPECT_FALSE(interpolated({{0.5, 1, 0}}, 0.5));
}

}  // namespace
}  // namespace fretval::interpolated_test
