#include "mdr/support/exponential_sum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace fretval::mdr::exponential_sum_test {
namespace {

TEST(ExponentialSum, IsWhatItsFormulaSays) {
  const ExponentialSum f{1, -2, {3, -0.5}, {0.1, 10}};
  EXPECT_EQ(f(0), 1 + 3 - 0.5);
  EXPECT_NEAR(f(2), 1 - 4 + 3 * std::exp(-0.2) - 0.5 * std::exp(-20), 1e-14);
}

// Of e^-s - e^-2s the maximum is 1/4, at ln 2.
TEST(ExponentialSum, HasItsSupremumInside) {
  const ExponentialSum f{0, 0, {1, -1}, {1, 2}};
  const double bound = supremum(f, 5, 1e-12);
  EXPECT_GE(bound, 0.25);
  EXPECT_LE(bound, 0.25 + 2e-12);
  EXPECT_NEAR(supremum(f, 0.1, 1e-12), std::exp(-0.1) - std::exp(-0.2), 2e-12);
}

// A peak of a width of 1e-6 of the interval, which samples would miss.
TEST(ExponentialSum, HasItsSupremumNextToTheStart) {
  const ExponentialSum f{0, 0, {1, -1}, {1e6, 2e6}};
  EXPECT_NEAR(supremum(f, 1, 1e-12), 0.25, 2e-12);
}

// A sample is never above; the densest one is below by f'' h^2/8 at most.
TEST(ExponentialSum, HasASupremumAboveAllSamplesAndHardlyMore) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int i = 0; i < 50; ++i) {
    ExponentialSum f{unit(random), unit(random), {}, {}};
    for (int k = 0; k < 4; ++k) {
      f.coefficients.push_back(unit(random));
      f.rates.push_back(std::pow(10, unit(random)));
    }
    constexpr int n = 4000;
    const double length = 3, error = 1e-10;
    double largest = -1e300;
    for (int k = 0; k <= n; ++k) largest = std::max(largest, f(length * k / n));
    const double bound = supremum(f, length, error), bend = 4 * 100.0;
    EXPECT_GE(bound, largest);
    EXPECT_LE(bound, largest + bend * std::pow(length / n, 2) / 8 + 2 * error);
  }
}

}  // namespace
}  // namespace fretval::mdr::exponential_sum_test
