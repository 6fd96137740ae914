#pragma once

#include <Eigen/Dense>
#include <cereal/cereal.hpp>
#include <cstddef>

namespace Eigen {

/// Vectors and matrices in an archive of cereal: rows, columns, coefficients.
template <class Archive, class Number, int rows, int columns>
void save(Archive& archive, const Matrix<Number, rows, columns>& matrix) {
  archive(matrix.rows(), matrix.cols(),
          cereal::binary_data(matrix.data(), static_cast<std::size_t>(matrix.size()) * sizeof(Number)));
}

template <class Archive, class Number, int rows, int columns>
void load(Archive& archive, Matrix<Number, rows, columns>& matrix) {
  Index n_rows = 0, n_columns = 0;
  archive(n_rows, n_columns);
  matrix.resize(n_rows, n_columns);
  archive(cereal::binary_data(matrix.data(), static_cast<std::size_t>(matrix.size()) * sizeof(Number)));
}

}  // namespace Eigen
