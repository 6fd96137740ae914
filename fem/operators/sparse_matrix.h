#pragma once

#include <vector>

namespace fretval::fem {

/// A square sparse matrix in compressed rows, both triangles stored.
struct SparseMatrix {
  int n = 0;
  std::vector<int> row_start;  ///< n + 1
  std::vector<int> columns;    ///< sorted within a row
  std::vector<double> values;
};

}  // namespace fretval::fem
