#include "mdr/layer/layer_kernel.h"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>

#include "mdr/layer/layer_response.h"
#include "mdr/support/constants.h"
#include "mdr/support/gauss_legendre.h"
#include "tests/mdr/error_of.h"

namespace fretval::mdr::layer_kernel_test {
namespace {

using boost::math::quadrature::gauss_kronrod;

// Half a turn of the cosine after the other, adaptively.
double kernel_by_quadrature(const Layer& layer, Direction direction, double x) {
  const double end = 25 / layer.thickness, part = std::min(1 / layer.thickness, pi / std::max(x, 1e-9));
  double sum = 0;
  for (double k = 0; k < end; k += part)
    sum += gauss_kronrod<double, 31>::integrate(
        [&](double at) { return response_ratio_less_one(layer, direction, at * layer.thickness) * std::cos(at * x); },
        k, k + part, 5, 1e-14);
  return sum;
}

TEST(LayerKernel, IsTheIntegralToRoundoff) {
  const double H = 0.7;
  for (const Layer& layer : {Layer{H, 0.5}, Layer{H, 0}, Layer{H, 0.3, LayerBase::frictionless}}) {
    for (const Direction direction : {Direction::normal, Direction::tangential}) {
      if (layer.base == LayerBase::frictionless && direction == Direction::tangential) continue;
      for (const double reach : {3.0, 60.0}) {
        const LayerKernel kernel = layer_kernel(layer, direction, reach);
        for (const double share : {0.0, 0.01, 0.3, 0.9, 1.0})
          EXPECT_NEAR(kernel_value(kernel, share * reach), kernel_by_quadrature(layer, direction, share * reach), 2e-14)
              << share * reach;
      }
    }
  }
}

// The corner of L at k = 0, where it rises by L' = (1-2 nu)/(2(1-nu)^2), leaves -L' H/x^2; the next term is of order
// (H/x)^4. Where L begins with kappa^3 the corner is one of the third derivative, 4, and leaves 4 (H/x)^3/x.
TEST(LayerKernel, FallsOffAsTheCornerOfTheResponseSays) {
  const double x = 100, nu = 0.3;
  EXPECT_NEAR(kernel_value(layer_kernel({1, nu}, Direction::normal, x), x) * x * x,
              -(1 - 2 * nu) / (2 * (1 - nu) * (1 - nu)), 1e-3);
  EXPECT_NEAR(kernel_value(layer_kernel({1, nu}, Direction::tangential, x), x) * x * x, -2 / (2 - nu), 1e-3);
  EXPECT_NEAR(kernel_value(layer_kernel({1, 0.5}, Direction::normal, x), x) * std::pow(x, 4), 4, 0.02);
}

TEST(LayerKernel, HasTheUnitsOfAnInverseLength) {
  const double at_one = kernel_value(layer_kernel({1, 0.4}, Direction::normal, 4), 1.5);
  EXPECT_NEAR(kernel_value(layer_kernel({1e-6, 0.4}, Direction::normal, 4e-6), 1.5e-6) * 1e-6, at_one, 1e-15);
}

// (1/pi) int K(x-y) q(y) dy, both sides of the axis, and its slope; the kernel itself is the oracle.
TEST(LayerKernel, CouplesAsItsIntegralSays) {
  const double a = 1.3;
  const LayerKernel kernel = layer_kernel({0.8, 0.5}, Direction::normal, 2 * a + 1);
  const QuadratureRule rule = gauss_legendre({0, a}, 20);
  const auto q = [](double y) { return 1 - y * y / 2; };
  const Eigen::ArrayXd load = rule.point.unaryExpr(q), a_m = amplitudes(kernel, rule.point, rule.weight * load);
  const auto by_kernel = [&](double x) {
    return gauss_kronrod<double, 61>::integrate([&](double y) { return kernel_value(kernel, x - y) * q(y); }, -a, a, 5,
                                                1e-14) /
           pi;
  };
  for (const double x : {0.0, 0.4, 1.3, 1.8}) {
    EXPECT_NEAR(coupling(kernel, a_m, x), by_kernel(x), 4e-15);
    const double h = 1e-4;
    EXPECT_NEAR(coupling_slope(kernel, a_m, x), (by_kernel(x + h) - by_kernel(std::abs(x - h))) / (2 * h), 1e-8);
  }
  const Eigen::ArrayXd at_points = (coupling_matrix(kernel, rule.point, rule.weight) * load.matrix()).array();
  EXPECT_LT((at_points - coupling(kernel, a_m, rule.point)).abs().maxCoeff(), 4e-16 * 20);
}

TEST(LayerKernel, RejectsBadArguments) {
  EXPECT_NE(error_of([] { layer_kernel({1, 0.5}, Direction::normal, 0); }).find("reach"), std::string::npos);
  EXPECT_NE(error_of([] { layer_kernel({1, 0.5}, Direction::normal, 300); }).find("thickness"), std::string::npos);
  EXPECT_NE(error_of([] {
              kernel_value(layer_kernel({1, 0.5}, Direction::normal, 3), 4);
            }).find("distance"),
            std::string::npos);
  EXPECT_NE(error_of([] {
              layer_kernel({1, 0.5, LayerBase::frictionless}, Direction::tangential, 1);
            }).find("frictionless"),
            std::string::npos);
}

}  // namespace
}  // namespace fretval::mdr::layer_kernel_test
