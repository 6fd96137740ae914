#include "fem/condensation/condensation.h"

#include <utility>

namespace fretval::fem {

Condensation::Condensation(const SparseMatrix& matrix, const std::vector<unsigned>& interface_dofs, std::string name)
    : factor_(matrix, interface_dofs, std::move(name)), schur_(factor_.schur_complement()) {
  factor_.probe();  // a wrong factor must not survive its own construction
}

Eigen::VectorXd Condensation::solve(const Eigen::VectorXd& rhs) const {
  return factor_.solve(rhs);
}

Eigen::VectorXd solve_uncondensed(const SparseMatrix& matrix, const Eigen::VectorXd& rhs, const std::string& name) {
  return SparseFactor(matrix, name).solve(rhs);
}

}  // namespace fretval::fem
