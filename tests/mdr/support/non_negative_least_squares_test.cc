#include "mdr/support/non_negative_least_squares.h"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

#include "tests/worse.h"

namespace fretval::mdr::non_negative_least_squares_test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

class Random {
 public:
  MatrixXd matrix(Index rows, Index columns) {
    return MatrixXd::NullaryExpr(rows, columns, [this] { return normal(engine); });
  }

 private:
  std::mt19937 engine{7};
  std::normal_distribution<double> normal;
};

// Largest violation of the optimality conditions, relative to |a_j| |b|.
double kkt_violation(const MatrixXd& A, const VectorXd& b, const VectorXd& x) {
  const VectorXd descent = A.transpose() * (b - A * x);
  double worst = 0;
  for (Index j = 0; j < x.size(); ++j) {
    const double scale = A.col(j).norm() * b.norm();
    if (scale == 0) continue;
    worst = worse(worst, (x(j) > 0 ? std::abs(descent(j)) : descent(j)) / scale);
  }
  return worst;
}

// Least residual over all sets of columns in use whose free solution is not negative.
double brute_force_residual(const MatrixXd& A, const VectorXd& b) {
  double least = b.norm();
  for (unsigned subset = 1; subset < (1u << A.cols()); ++subset) {
    std::vector<Index> in_use;
    for (Index j = 0; j < A.cols(); ++j) {
      if (subset >> j & 1u) in_use.push_back(j);
    }
    const MatrixXd columns = A(Eigen::all, in_use);
    const VectorXd z = columns.completeOrthogonalDecomposition().solve(b);
    if (z.minCoeff() >= 0) least = std::min(least, (columns * z - b).norm());
  }
  return least;
}

constexpr double roundoff = 1e-13;  // about a thousand operations in double precision

TEST(NonNegativeLeastSquares, IsBestOfAllActiveSets) {
  Random random;
  for (int trial = 0; trial < 200; ++trial) {
    const Index n = 1 + trial % 7;
    const Index m = 1 + trial % 10;  // fewer rows than columns too
    const MatrixXd A = random.matrix(m, n);
    const VectorXd b = random.matrix(m, 1);
    const VectorXd x = non_negative_least_squares(A, b);
    EXPECT_GE(x.minCoeff(), 0);
    EXPECT_NEAR((A * x - b).norm(), brute_force_residual(A, b), roundoff * b.norm()) << trial;
    EXPECT_LT(kkt_violation(A, b, x), roundoff);
  }
}

TEST(NonNegativeLeastSquares, RecoversANonNegativeSolution) {
  Random random;
  for (int trial = 0; trial < 20; ++trial) {
    const MatrixXd A = random.matrix(30, 12);
    VectorXd exact = random.matrix(12, 1).cwiseMax(0);
    EXPECT_LT((non_negative_least_squares(A, A * exact) - exact).norm(), roundoff * 10);  // condition below 10
  }
}

TEST(NonNegativeLeastSquares, KeepsOptimalityForLargeRandomProblems) {
  Random random;
  const MatrixXd A = random.matrix(300, 80);
  const VectorXd b = random.matrix(300, 1);
  EXPECT_LT(kkt_violation(A, b, non_negative_least_squares(A, b)), roundoff);
}

// Relaxation kernels of close times: condition beyond 1e16, the case of the Prony fit.
TEST(NonNegativeLeastSquares, KeepsOptimalityForIllConditionedProblems) {
  Random random;
  for (const int per_decade : {1, 4, 20}) {
    const Index m = 120, n = Index{6} * per_decade;
    const MatrixXd A = MatrixXd::NullaryExpr(m, n, [&](Index i, Index j) {
      return 1 / (1 + std::pow(10, 6.0 * static_cast<double>(i) / m - static_cast<double>(j) / per_decade));
    });
    const VectorXd b = A * random.matrix(n, 1).cwiseAbs() + 0.02 * random.matrix(m, 1);
    const VectorXd x = non_negative_least_squares(A, b);
    EXPECT_GE(x.minCoeff(), 0);
    EXPECT_LT(kkt_violation(A, b, x), 10 * roundoff) << per_decade;  // and the truncated rank
  }
}

TEST(NonNegativeLeastSquares, IsIndependentOfTheScaleOfColumns) {
  Random random;
  const MatrixXd A = random.matrix(12, 5);
  const VectorXd b = random.matrix(12, 1);
  const VectorXd x = non_negative_least_squares(A, b);
  const VectorXd scales = (VectorXd(5) << 1e-150, 1e9, 1, 1e-12, 1e200).finished();
  const VectorXd scaled = non_negative_least_squares(A * scales.asDiagonal(), 1e-30 * b);
  EXPECT_LT((scaled.cwiseProduct(scales) * 1e30 - x).norm(), roundoff);
}

TEST(NonNegativeLeastSquares, TakesDependentAndZeroColumns) {
  MatrixXd A(2, 4);
  A << 1, 1, 0, -1, 2, 2, 0, 0;
  const VectorXd x = non_negative_least_squares(A, Eigen::Vector2d(3, 6));
  EXPECT_NEAR(x(0) + x(1), 3, roundoff);
  EXPECT_EQ(x(2), 0);
  EXPECT_EQ(non_negative_least_squares(-A.leftCols(2), Eigen::Vector2d(3, 6)), Eigen::Vector2d(0, 0));
  EXPECT_EQ(non_negative_least_squares(A, Eigen::Vector2d(0, 0)), Eigen::Vector4d::Zero());
}

TEST(NonNegativeLeastSquares, StopsAtTheCapWithAnError) {
  Random random;
  const MatrixXd A = random.matrix(30, 12).cwiseAbs();
  const VectorXd b = A * VectorXd::Ones(12);
  EXPECT_THROW(non_negative_least_squares(A, b, 2), std::runtime_error);
}

TEST(NonNegativeLeastSquares, RejectsBadInput) {
  const MatrixXd A = MatrixXd::Ones(3, 2);
  EXPECT_THROW(non_negative_least_squares(A, VectorXd::Ones(2)), std::invalid_argument);
  EXPECT_THROW(non_negative_least_squares(MatrixXd(3, 0), VectorXd::Ones(3)), std::invalid_argument);
  EXPECT_THROW(non_negative_least_squares(A, VectorXd::Constant(3, std::numeric_limits<double>::infinity())),
               std::invalid_argument);
}

}  // namespace
}  // namespace fretval::mdr::non_negative_least_squares_test
