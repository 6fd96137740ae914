#pragma once

#include <Eigen/Dense>
#include <vector>

namespace fretval::fem {

/// A symmetric sparse matrix, the upper triangle in compressed rows. Each row begins with its diagonal, which may be 0.
struct SparseMatrix {
  int n = 0;
  std::vector<int> row_start;  ///< n + 1
  std::vector<int> columns;    ///< sorted within a row
  std::vector<double> values;
};

inline Eigen::VectorXd multiply(const SparseMatrix& matrix, const Eigen::VectorXd& x) {
  Eigen::VectorXd y = Eigen::VectorXd::Zero(matrix.n);
  for (int row = 0; row < matrix.n; ++row) {
    const int diagonal = matrix.row_start[row];
    double sum = matrix.values[diagonal] * x[row];
    for (int k = diagonal + 1; k < matrix.row_start[row + 1]; ++k) {
      sum += matrix.values[k] * x[matrix.columns[k]];
      y[matrix.columns[k]] += matrix.values[k] * x[row];
    }
    y[row] += sum;
  }
  return y;
}

}  // namespace fretval::fem
