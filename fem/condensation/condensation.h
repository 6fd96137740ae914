#pragma once

#include <Eigen/Dense>
#include <string>
#include <vector>

#include "fem/condensation/sparse_factor.h"
#include "fem/operators/sparse_matrix.h"

namespace fretval::fem {

/// One MUMPS factorisation (through PETSc) of a symmetric indefinite matrix K with its Schur complement
/// `S = K_cc - K_ci K_ii^{-1} K_ic` on the interface dofs c.
///
/// Every failure is a SolverError that names the matrix: non-finite entries, empty rows, MUMPS' INFOG codes, a singular
/// matrix, a non-finite Schur complement, and a probe solve whose true residual is above 1e-8. Needs a PetscSession.
class Condensation {
 public:
  /// name: of the matrix, for error messages.
  Condensation(const SparseMatrix& matrix, const std::vector<unsigned>& interface_dofs, std::string name);

  /// S, n_interface x n_interface, in the order of interface_dofs.
  [[nodiscard]] const Eigen::MatrixXd& schur_complement() const { return schur_; }

  /// Solves K x = rhs for all dofs, through the condensed system.
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& rhs) const;

 private:
  SparseFactor factor_;
  Eigen::MatrixXd schur_;
};

/// The solve without condensation: a plain MUMPS factorisation of all of K. It verifies Condensation.
Eigen::VectorXd solve_uncondensed(const SparseMatrix& matrix, const Eigen::VectorXd& rhs, const std::string& name);

}  // namespace fretval::fem
