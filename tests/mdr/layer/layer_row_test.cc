#include "mdr/layer/layer_row.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace fretval::mdr::layer_row_test {
namespace {

const Layer layer{0.5, 0.5};

// A load that is made up, the depths that belong to it, and back.
TEST(LayerRow, GivesBackTheLoadThatMadeTheDepths) {
  const LayerKernel kernel = layer_kernel(layer, Direction::normal, 2);
  const QuadratureRule fine = gauss_legendre({0, 0.5, 1}, 30);
  const auto q = [](double x) { return std::cos(x) - x * x / 3; };
  const Eigen::ArrayXd parts = amplitudes(kernel, fine.point, fine.weight * fine.point.unaryExpr(q));
  const LayerRow row = layer_row(parabola(1), layer, Direction::normal, 1, 1);
  const Eigen::ArrayXd made = row.points().unaryExpr(q), depth = made + coupling(kernel, parts, row.points());
  // Roundoff times the condition of the row, whose smallest L is some 1/30 here.
  EXPECT_LT((row.load(depth) - made).abs().maxCoeff(), 1e-13);
  EXPECT_GT((row.load(made) - made).abs().maxCoeff(), 0.1);  // without the coupling
  EXPECT_NEAR(row.integral(made), std::sin(1) - 1.0 / 9, 1e-14);
}

// Doubling the points about squares the error; measured 6e-3, 2e-4, 1e-9, 1e-16.
TEST(LayerRow, ConvergesSpectrally) {
  const auto stiffness = [](int n) {
    const LayerRow row = layer_row(parabola(1), layer, Direction::normal, 1, 1, {n});
    return row.integral(row.load(Eigen::ArrayXd::Ones(row.points().size())));
  };
  const double exact = stiffness(40);
  EXPECT_GT(std::abs(stiffness(2) / exact - 1), 1e-5);
  EXPECT_LT(std::abs(stiffness(4) / exact - 1), 1e-3);
  EXPECT_LT(std::abs(stiffness(8) / exact - 1), 1e-8);
  EXPECT_LT(std::abs(stiffness(16) / exact - 1), 1e-14);
}

TEST(LayerRow, BreaksAreWhereTheImageIsNotSmooth) {
  EXPECT_EQ(row_breaks(parabola(1), layer, 1), (std::vector<double>{0, 1}));
  EXPECT_EQ(row_breaks(cone(0.1), layer, 2), (std::vector<double>{0, 1, 2}));
  const auto flat = row_breaks(rounded_flat(0.4, 1), layer, 1);
  EXPECT_TRUE(std::find(flat.begin(), flat.end(), 0.4) != flat.end());
  EXPECT_GT(flat.size(), 10U);
  EXPECT_GT(row_breaks(power_law(1, 1.5), layer, 1).size(), 10U);
  EXPECT_TRUE(std::is_sorted(flat.begin(), flat.end()));
}

}  // namespace
}  // namespace fretval::mdr::layer_row_test
