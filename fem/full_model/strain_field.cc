#include "fem/full_model/strain_field.h"

#include <utility>

#include "fem/operators/strain_operator.h"

namespace fretval::fem {

StrainField::StrainField(const HarmonicSpace& space) : n_dofs_(space.n_dofs()), n_strains_(0) {
  const auto& parts = space.parts();
  CellOperators operators(space);
  std::vector<dealii::types::global_dof_index> dofs(parts.element.n_dofs_per_cell());
  for (const auto& cell : parts.dofs.active_cell_iterators()) {
    operators.evaluate(cell);
    cell->get_dof_indices(dofs);
    Eigen::MatrixXd strain(operators.strain().rows() + operators.far().rows(), operators.strain().cols());
    strain << operators.strain(), operators.far();
    n_strains_ += strain.rows();
    cells_.push_back({{}, std::move(strain)});
    for (const unsigned shape : operators.displacement_shapes()) cells_.back().dofs.push_back(dofs[shape]);
  }
  for (unsigned i = 0; i < space.n_dofs(); ++i)
    if (parts.constraints.is_constrained(i)) constrained_.push_back(i);
}

Eigen::VectorXd StrainField::of(const Eigen::VectorXd& field) const {
  Eigen::VectorXd strain(n_strains_);
  Eigen::Index begin = 0;
  for (const auto& cell : cells_) {
    strain.segment(begin, cell.strain.rows()).noalias() = cell.strain * field(cell.dofs);
    begin += cell.strain.rows();
  }
  return strain;
}

Eigen::VectorXd StrainField::force(const Eigen::VectorXd& stress) const {
  Eigen::VectorXd force = Eigen::VectorXd::Zero(n_dofs_);
  Eigen::Index begin = 0;
  for (const auto& cell : cells_) {
    force(cell.dofs) += cell.strain.transpose() * stress.segment(begin, cell.strain.rows());
    begin += cell.strain.rows();
  }
  for (const unsigned dof : constrained_) force[dof] = 0;
  return force;
}

}  // namespace fretval::fem
