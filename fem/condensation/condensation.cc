#include "fem/condensation/condensation.h"

#include <cmath>
#include <utility>

namespace fretval::fem {
namespace {

Eigen::VectorXd probe(int n) {
  Eigen::VectorXd rhs(n);
  for (int i = 0; i < n; ++i) rhs[i] = std::sin(1.0 + 0.7 * i);
  return rhs;
}

}  // namespace

Condensation::Condensation(const SparseMatrix& matrix, const std::vector<unsigned>& interface_dofs, std::string name)
    : factor_(matrix, interface_dofs, std::move(name)), schur_(factor_.schur_complement()) {
  static_cast<void>(solve(probe(matrix.n)));  // a wrong factor must not survive its own construction
}

Eigen::VectorXd Condensation::solve(const Eigen::VectorXd& rhs) const {
  return factor_.solve(rhs);
}

Eigen::VectorXd solve_uncondensed(const SparseMatrix& matrix, const Eigen::VectorXd& rhs, const std::string& name) {
  return SparseFactor(matrix, name).solve(rhs);
}

}  // namespace fretval::fem
