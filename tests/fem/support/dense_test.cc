#include "fem/support/dense.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "tests/fem/expect_solver_error.h"
#include "tests/fem/random_vector.h"

namespace fretval::fem::dense_test {
namespace {

using Eigen::MatrixXd;

MatrixXd random_matrix(Eigen::Index rows, Eigen::Index columns, unsigned seed) {
  return random_vector(rows * columns, seed).reshaped(rows, columns);
}

MatrixXd positive_definite(Eigen::Index n) {
  const MatrixXd half = random_matrix(n, n, 1);
  return half * half.transpose() + MatrixXd::Identity(n, n);
}

constexpr double roundoff = 1e-12;  // 1e-16 by n and the condition, 70 and 100

// Second method: Eigen's own.
TEST(Dense, CholeskyIsThatOfEigen) {
  for (const Eigen::Index n : {1, 2, 7, 70}) {
    const MatrixXd matrix = positive_definite(n), expected = matrix.llt().matrixL();
    const auto factor = cholesky(matrix);
    ASSERT_TRUE(factor);
    EXPECT_LT((*factor - expected).norm(), roundoff * expected.norm()) << n;
    EXPECT_EQ(MatrixXd(factor->triangularView<Eigen::StrictlyUpper>()), MatrixXd::Zero(n, n));
  }
}

TEST(Dense, CholeskyOfWhatIsNotPositiveDefiniteIsEmpty) {
  MatrixXd indefinite = positive_definite(7), singular = indefinite;
  indefinite(6, 6) = -1;
  singular.row(3).setZero();
  singular.col(3).setZero();
  for (const MatrixXd& matrix : {indefinite, singular}) EXPECT_FALSE(cholesky(matrix));
}

// What lies above the diagonal is none of the triangle.
TEST(Dense, SolvesALowerTriangle) {
  MatrixXd lower = *cholesky(positive_definite(70));
  const MatrixXd rhs = random_matrix(70, 3, 2), expected = lower.triangularView<Eigen::Lower>().solve(rhs);
  lower.triangularView<Eigen::StrictlyUpper>().setConstant(7);
  EXPECT_LT((solve_lower(lower, rhs) - expected).norm(), roundoff * expected.norm());
}

TEST(Dense, MultipliesByWholeMatrices) {
  for (const Eigen::Index n : {1, 3, 4, 15, 16, 17, 36, 70}) {
    const MatrixXd matrix = random_matrix(n, 9, 3), x = random_matrix(9, 3, 4), expected = matrix * x;
    MatrixXd product(n, 3);
    multiply(matrix, x, product);
    EXPECT_LT((product - expected).norm(), roundoff * expected.norm()) << n;
    multiply_by_transpose(MatrixXd(matrix.transpose()), x, product);
    EXPECT_LT((product - expected).norm(), roundoff * expected.norm()) << n;
  }
}

// In both precisions, a column or several, into rows of a matrix that has more.
TEST(Dense, MultipliesBySymmetricMatrices) {
  constexpr float single = 1e-6F;
  for (const Eigen::Index n : {1, 3, 16, 37})
    for (const Eigen::Index n_columns : {1, 2, 5}) {
      const MatrixXd matrix = positive_definite(n), x = random_matrix(n + 2, n_columns, 4),
                     expected = matrix * x.topRows(n);
      MatrixXd product = MatrixXd::Zero(n + 1, n_columns);
      multiply_symmetric(matrix, x.topRows(n), product.topRows(n));
      EXPECT_LT((product.topRows(n) - expected).norm(), roundoff * expected.norm()) << n;
      EXPECT_EQ(product.row(n).norm(), 0);
      const Eigen::MatrixXf in_single = matrix.cast<float>(), x_in_single = x.cast<float>();
      Eigen::MatrixXf single_product(n, n_columns);
      multiply_symmetric(in_single, x_in_single.topRows(n), single_product);
      EXPECT_LT((single_product - expected.cast<float>()).norm(), single * expected.cast<float>().norm()) << n;
      multiply(in_single, x_in_single.topRows(n), single_product);
      EXPECT_LT((single_product - expected.cast<float>()).norm(), single * expected.cast<float>().norm()) << n;
    }
}

TEST(Dense, InvertsWhatIsPositiveDefiniteAlone) {
  for (const Eigen::Index n : {1, 2, 7, 70}) {
    const MatrixXd matrix = positive_definite(n);
    const auto inverted = inverse(matrix);
    ASSERT_TRUE(inverted);
    EXPECT_LT((*inverted * matrix - MatrixXd::Identity(n, n)).norm(), 100 * roundoff * n) << n;
  }
  EXPECT_FALSE(inverse(-positive_definite(7)));
}

// Of any leading or trailing rows and columns, in place, whether they divide by four or not.
TEST(Dense, MultipliesVectorsByTriangles) {
  const MatrixXd lower = *cholesky(positive_definite(70));
  for (const Eigen::Index n : {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 36, 69, 70}) {
    const MatrixXd leading = lower.topLeftCorner(n, n), trailing = lower.bottomRightCorner(n, n);
    for (Eigen::Index first = 0; first <= n; first += std::max<Eigen::Index>(n / 9, 1))
      for (const Eigen::Index n_zeros_at_end : {Eigen::Index{0}, n / 5, n - first}) {
        Eigen::VectorXd x = random_vector(n, 4);
        x.head(first).setZero();
        x.tail(n_zeros_at_end).setZero();
        const Eigen::VectorXd expected = leading.transpose() * x, expected_of_trailing = trailing * x;
        Eigen::VectorXd product = x;
        multiply_trailing(lower, product);
        multiply_transposed(lower, x, first);
        Eigen::VectorXd of_block = x.head(n - first);
        const Eigen::VectorXd expected_of_block = lower.block(first, first, n - first, n - first) * of_block;
        multiply_block(lower, first, of_block);
        EXPECT_LE((of_block - expected_of_block).norm(), roundoff * expected_of_block.norm()) << n << ' ' << first;
        EXPECT_LE((x - expected).norm(), roundoff * expected.norm()) << n << ' ' << first << ' ' << n_zeros_at_end;
        EXPECT_LE((product - expected_of_trailing).norm(), roundoff * expected_of_trailing.norm()) << n << ' ' << first;
      }
  }
}

TEST(Dense, SolvesWithAnySquareMatrix) {
  const MatrixXd matrix = random_matrix(40, 40, 5);
  const Eigen::VectorXd expected = random_vector(40, 6);
  EXPECT_LT((solve_square(matrix, matrix * expected) - expected).norm(), 1e3 * roundoff * expected.norm());
  expect_solver_error([] { solve_square(MatrixXd::Zero(2, 2), Eigen::Vector2d(1, 1)); }, {"singular"});
}

TEST(Dense, GramIsBothTrianglesOfTheProduct) {
  for (const auto& [rows, columns] : {std::pair{1, 5}, {70, 3}, {3, 70}}) {
    const MatrixXd half = random_matrix(rows, columns, 3), expected = half.transpose() * half, product = gram(half);
    EXPECT_LT((product - expected).norm(), roundoff * expected.norm());
    EXPECT_EQ(product, product.transpose());
  }
}

}  // namespace
}  // namespace fretval::fem::dense_test
