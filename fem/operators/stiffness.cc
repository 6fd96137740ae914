#include "fem/operators/stiffness.h"

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_matrix.h>

#include <algorithm>

#include "fem/operators/strain_operator.h"
#include "fem/support/dense.h"

namespace fretval::fem {
namespace {

Eigen::MatrixXd cell_stiffness(const CellOperators& operators) {
  const Eigen::MatrixXd coupling = operators.divergence().transpose() * operators.pressure();
  Eigen::MatrixXd matrix = gram(operators.strain()) - coupling - coupling.transpose();
  if (operators.far().rows() > 0) matrix += gram(operators.far());
  return matrix;
}

SparseMatrix to_rows(const dealii::SparseMatrix<double>& matrix) {
  SparseMatrix rows;
  rows.n = static_cast<int>(matrix.m());
  rows.row_start.assign(1, 0);
  rows.columns.reserve(matrix.n_nonzero_elements());
  rows.values.reserve(matrix.n_nonzero_elements());
  std::vector<std::pair<int, double>> entries;
  for (int row = 0; row < rows.n; ++row) {
    entries.clear();
    for (auto it = matrix.begin(row); it != matrix.end(row); ++it)
      entries.emplace_back(static_cast<int>(it->column()), it->value());
    std::sort(entries.begin(), entries.end());  // deal.II stores the diagonal first
    for (const auto& [column, value] : entries) {
      rows.columns.push_back(column);
      rows.values.push_back(value);
    }
    rows.row_start.push_back(static_cast<int>(rows.columns.size()));
  }
  return rows;
}

}  // namespace

SparseMatrix assemble_stiffness(const HarmonicSpace& space) {
  const auto& parts = space.parts();
  const unsigned n_cell_dofs = parts.element.n_dofs_per_cell();
  dealii::DynamicSparsityPattern dynamic_pattern(parts.dofs.n_dofs());
  dealii::DoFTools::make_sparsity_pattern(parts.dofs, dynamic_pattern, parts.constraints, false);
  dealii::SparsityPattern pattern;
  pattern.copy_from(dynamic_pattern);
  dealii::SparseMatrix<double> matrix(pattern);

  CellOperators operators(space);
  dealii::FullMatrix<double> cell_matrix(n_cell_dofs, n_cell_dofs);
  std::vector<dealii::types::global_dof_index> dofs(n_cell_dofs);
  for (const auto& cell : parts.dofs.active_cell_iterators()) {
    operators.evaluate(cell);
    const Eigen::MatrixXd dense = cell_stiffness(operators);
    for (unsigned i = 0; i < n_cell_dofs; ++i)
      for (unsigned j = 0; j < n_cell_dofs; ++j) cell_matrix(i, j) = dense(i, j);
    cell->get_dof_indices(dofs);
    parts.constraints.distribute_local_to_global(cell_matrix, dofs, matrix);
  }
  return to_rows(matrix);
}

}  // namespace fretval::fem
