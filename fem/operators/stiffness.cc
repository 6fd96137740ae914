#include "fem/operators/stiffness.h"

#include <algorithm>
#include <cstdint>

#include "fem/operators/strain_operator.h"
#include "fem/support/dense.h"

namespace fretval::fem {
namespace {

/// A symmetric matrix over some dofs, which ascend: those inside the cell are the last ones.
struct CellStiffness {
  std::vector<int> dofs;
  Eigen::MatrixXd matrix;
};

/// Displacements before pressures.
Eigen::MatrixXd stiffness_of(const CellOperators& operators, const Compressibility& bulk, double modulus) {
  const auto n = operators.strain().cols(), n_pressures = operators.pressure().cols();
  Eigen::MatrixXd matrix(n + n_pressures, n + n_pressures);
  matrix.topLeftCorner(n, n) = gram(operators.strain());
  if (bulk.shift > 0) matrix.topLeftCorner(n, n) -= bulk.shift * gram(operators.divergence());
  if (modulus != 1) matrix.topLeftCorner(n, n) *= modulus;
  if (operators.far().rows() > 0) matrix.topLeftCorner(n, n) += gram(operators.far());
  matrix.topRightCorner(n, n_pressures).noalias() = -operators.divergence().transpose() * operators.pressure();
  matrix.bottomLeftCorner(n_pressures, n) = matrix.topRightCorner(n, n_pressures).transpose();
  matrix.bottomRightCorner(n_pressures, n_pressures).setZero();
  if (bulk.yielding > 0 && n_pressures > 0)  // torsion has none, and BLAS takes no empty matrix
    matrix.bottomRightCorner(n_pressures, n_pressures) = -bulk.yielding / modulus * gram(operators.pressure());
  return matrix;
}

bool has(const Share& share, unsigned cell, unsigned n_cells) {
  return std::uint64_t{cell} * share.count / n_cells == share.number;
}

/// Calls `use` with the stiffness of each cell of a share over its free dofs.
template <class Use>
void for_each_cell(const HarmonicSpace& space, const Share& share, Use&& use) {
  const auto& parts = space.parts();
  CellOperators operators(space);
  auto shapes = operators.displacement_shapes();
  shapes.insert(shapes.end(), operators.pressure_shapes().begin(), operators.pressure_shapes().end());
  std::vector<dealii::types::global_dof_index> dofs(shapes.size());
  const auto& moduli = space.elasticity().moduli;
  const auto bulk = compressibility(space.elasticity().poisson_ratio);
  for (const auto& cell : parts.dofs.active_cell_iterators()) {
    if (!has(share, cell->active_cell_index(), parts.triangulation.n_active_cells())) continue;
    operators.evaluate(cell);
    cell->get_dof_indices(dofs);
    std::vector<Eigen::Index> order;
    for (std::size_t i = 0; i < shapes.size(); ++i)
      if (!parts.constraints.is_constrained(dofs[shapes[i]])) order.push_back(static_cast<Eigen::Index>(i));
    std::sort(order.begin(), order.end(), [&](auto a, auto b) { return dofs[shapes[a]] < dofs[shapes[b]]; });
    const double modulus = moduli.empty() ? 1 : moduli[cell->active_cell_index()];
    CellStiffness ordered{{}, stiffness_of(operators, bulk, modulus)(order, order)};
    for (const auto i : order) ordered.dofs.push_back(static_cast<int>(dofs[shapes[i]]));
    use(std::move(ordered));
  }
}

/// diagonal: of a row to which none of the cells contributes.
template <class Diagonal>
SparseMatrix sum_of(const std::vector<CellStiffness>& cells, unsigned n, const Diagonal& diagonal) {
  struct CellRow {
    const CellStiffness* cell;
    Eigen::Index row;
  };
  std::vector<std::vector<CellRow>> rows(n);
  for (const auto& cell : cells)
    for (std::size_t i = 0; i < cell.dofs.size(); ++i)
      rows[cell.dofs[i]].push_back({&cell, static_cast<Eigen::Index>(i)});

  SparseMatrix sum;
  sum.n = static_cast<int>(n);
  sum.row_start.push_back(0);
  std::vector<double> values(n, 0);
  std::vector<int> columns;
  std::vector<int> last_row(n, -1);
  for (int row = 0; row < sum.n; ++row) {
    columns.clear();
    for (const auto& [cell, i] : rows[row])
      for (auto j = i; j < cell->matrix.rows(); ++j) {
        const int column = cell->dofs[j];
        if (last_row[column] != row) {
          last_row[column] = row;
          columns.push_back(column);
          values[column] = 0;
        }
        values[column] += cell->matrix(j, i);
      }
    if (columns.empty()) {
      columns.push_back(row);
      values[row] = diagonal(row);
    }
    std::sort(columns.begin(), columns.end());
    for (const int column : columns) {
      sum.columns.push_back(column);
      sum.values.push_back(values[column]);
    }
    sum.row_start.push_back(static_cast<int>(sum.columns.size()));
  }
  return sum;
}

/// `-K_ii^{-1} K_is`: values inside a cell per value of its skeleton dofs.
Eigen::MatrixXd extension_of(const CellStiffness& cell, Eigen::Index n_skeleton) {
  const Eigen::Index n = cell.matrix.rows() - n_skeleton;
  return -cell.matrix.bottomRightCorner(n, n).partialPivLu().solve(cell.matrix.bottomLeftCorner(n, n_skeleton));
}

/// Number of the dofs of a cell that belong to the skeleton.
Eigen::Index n_skeleton_of(const CellStiffness& cell, unsigned n_skeleton_dofs) {
  return std::lower_bound(cell.dofs.begin(), cell.dofs.end(), static_cast<int>(n_skeleton_dofs)) - cell.dofs.begin();
}

}  // namespace

Compressibility compressibility(double poisson_ratio) {
  const double rest = 1 - 2 * poisson_ratio, shift = 2 * rest / 3;
  const double sum = 2 * poisson_ratio + shift * rest;  // (1 - 2 nu) (lambda + c)
  return {shift, rest / sum, (2 * poisson_ratio + shift) / sum};
}

SparseMatrix assemble_stiffness(const HarmonicSpace& space) {
  std::vector<CellStiffness> cells;
  for_each_cell(space, {}, [&](CellStiffness&& cell) { cells.push_back(std::move(cell)); });
  return sum_of(cells, space.n_dofs(), [](int) { return 1; });
}

SparseMatrix assemble_skeleton_stiffness(const HarmonicSpace& space, const Share& share) {
  std::vector<CellStiffness> cells;
  for_each_cell(space, share, [&](CellStiffness&& cell) {
    const auto n = n_skeleton_of(cell, space.n_skeleton_dofs()), n_inside = cell.matrix.rows() - n;
    const Eigen::MatrixXd yielding = cell.matrix.topRightCorner(n, n_inside) * extension_of(cell, n);
    cell.dofs.resize(n);
    cells.push_back({std::move(cell.dofs), cell.matrix.topLeftCorner(n, n) + yielding});
  });
  const auto& constraints = space.parts().constraints;
  return sum_of(cells, space.n_skeleton_dofs(),
                [&](int row) { return share.number == 0 && constraints.is_constrained(row) ? 1 : 0; });
}

Eigen::MatrixXd extend_into_cells(const HarmonicSpace& space, const Eigen::MatrixXd& skeleton) {
  Eigen::MatrixXd field(space.n_dofs(), skeleton.cols());
  field.topRows(skeleton.rows()) = skeleton;
  for_each_cell(space, {}, [&](const CellStiffness& cell) {
    const auto n = n_skeleton_of(cell, space.n_skeleton_dofs());
    const std::vector<int> outer(cell.dofs.begin(), cell.dofs.begin() + n);
    const std::vector<int> inner(cell.dofs.begin() + n, cell.dofs.end());
    field(inner, Eigen::all) = extension_of(cell, n) * field(outer, Eigen::all);
  });
  return field;
}

}  // namespace fretval::fem
