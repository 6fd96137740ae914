#pragma once

#include <Eigen/Dense>
#include <random>

#include "fem/operators/sparse_matrix.h"

namespace fretval::fem {

/// All entries of the upper triangle stored, zero or not.
inline SparseMatrix rows_of(const Eigen::MatrixXd& dense) {
  SparseMatrix rows;
  rows.n = static_cast<int>(dense.rows());
  rows.row_start.push_back(0);
  for (int i = 0; i < rows.n; ++i) {
    for (int j = i; j < rows.n; ++j) {
      rows.columns.push_back(j);
      rows.values.push_back(dense(i, j));
    }
    rows.row_start.push_back(static_cast<int>(rows.columns.size()));
  }
  return rows;
}

/// Zero on the diagonal, entries uniform in [-1, 1) elsewhere.
inline Eigen::MatrixXd random_symmetric(int n, unsigned seed) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < i; ++j) matrix(i, j) = matrix(j, i) = uniform(engine);
  return matrix;
}

/// A saddle point, like the stiffness: 6 displacements, 2 pressures.
inline Eigen::MatrixXd small_saddle_point() {
  Eigen::MatrixXd matrix = random_symmetric(8, 1);
  for (int i = 0; i < 6; ++i) matrix(i, i) = 6;
  matrix.bottomRightCorner(2, 2).setZero();
  return matrix;
}

}  // namespace fretval::fem
