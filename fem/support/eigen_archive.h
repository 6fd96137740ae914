#pragma once

#include <Eigen/Dense>
#include <cereal/cereal.hpp>
#include <cstddef>

namespace Eigen {

/// Vectors and matrices in an archive of cereal: rows, columns, coefficients.
template <class Archive, int rows, int columns>
void save(Archive& archive, const Matrix<double, rows, columns>& matrix) {
  archive(matrix.rows(), matrix.cols(),
          cereal::binary_data(matrix.data(), static_cast<std::size_t>(matrix.size()) * sizeof(double)));
}

template <class Archive, int rows, int columns>
void load(Archive& archive, Matrix<double, rows, columns>& matrix) {
  Index n_rows = 0, n_columns = 0;
  archive(n_rows, n_columns);
  matrix.resize(n_rows, n_columns);
  archive(cereal::binary_data(matrix.data(), static_cast<std::size_t>(matrix.size()) * sizeof(double)));
}

}  // namespace Eigen
