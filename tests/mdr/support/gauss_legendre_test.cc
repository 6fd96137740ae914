#include "mdr/support/gauss_legendre.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace fretval::mdr::gauss_legendre_test {
namespace {

// n points integrate polynomials up to the degree 2 n - 1, and not the next one.
TEST(GaussLegendre, IsExactUpToItsDegreeAndNotBeyond) {
  for (const int n : {1, 2, 5, 16, 30, 64}) {
    const QuadratureRule rule = gauss_legendre({0, 1}, n);
    for (int degree = 0; degree < 2 * n; ++degree)
      EXPECT_NEAR((rule.weight * rule.point.pow(degree)).sum(), 1.0 / (degree + 1), 4e-15) << n << " " << degree;
  }
  const QuadratureRule two = gauss_legendre({0, 1}, 2);
  EXPECT_NEAR((two.weight * two.point.pow(4)).sum() - 0.2, -1.0 / 180, 1e-15);
}

TEST(GaussLegendre, PanelsStandSideBySide) {
  const QuadratureRule rule = gauss_legendre({-1, 0.5, 2}, 20);
  ASSERT_EQ(rule.point.size(), 40);
  for (Eigen::Index j = 1; j < 40; ++j) EXPECT_GT(rule.point[j], rule.point[j - 1]);
  EXPECT_NEAR((rule.weight * rule.point.exp()).sum(), std::exp(2) - std::exp(-1), 1e-14);
  // A kink at a break costs nothing.
  EXPECT_NEAR((rule.weight * (rule.point - 0.5).abs()).sum(), 1.5 * 1.5, 1e-14);
}

TEST(GaussLegendre, RejectsBadArguments) {
  EXPECT_THROW(gauss_legendre({0}, 3), std::invalid_argument);
  EXPECT_THROW(gauss_legendre({1, 0}, 3), std::invalid_argument);
  EXPECT_THROW(gauss_legendre({0, 1}, 0), std::invalid_argument);
}

}  // namespace
}  // namespace fretval::mdr::gauss_legendre_test
