#pragma once

#include <Eigen/Dense>
#include <memory>
#include <string>
#include <vector>

#include "fem/condensation/mumps.h"
#include "fem/operators/sparse_matrix.h"

namespace fretval::fem {

/// One MUMPS factorisation (through PETSc) of a symmetric indefinite matrix K, on request with its Schur complement
/// `S = K_cc - K_ci K_ii^{-1} K_ic` on interface dofs c.
///
/// Every failure is a SolverError that names the matrix: non-finite entries, empty rows, MUMPS' INFOG codes, a singular
/// matrix, a non-finite Schur complement, and a solve whose true residual is above 1e-8. A work space
/// that turns out too small is made larger, once. Needs a PetscSession. Threads may use factors at the same time: they
/// wait for each other, as PETSc and MUMPS serve one at a time.
class SparseFactor {
 public:
  /// name: of the matrix, for error messages.
  SparseFactor(SparseMatrix matrix, std::string name);
  /// interface_dofs: the dofs c; empty: no Schur complement is made.
  SparseFactor(SparseMatrix matrix, const std::vector<unsigned>& interface_dofs, std::string name,
               const SpareMemory& spare = {});
  ~SparseFactor();
  SparseFactor(SparseFactor&&) noexcept;
  SparseFactor& operator=(SparseFactor&&) noexcept;

  /// S, n_interface x n_interface, in the order of interface_dofs.
  [[nodiscard]] Eigen::MatrixXd schur_complement() const;

  /// Throws SolverError unless one back-substitution with some rhs gives an x with K x = rhs.
  void probe() const;

  /// K^{-1} rhs: back-substitution and one refinement.
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& rhs) const;

 private:
  class Factored;  // PETSc objects
  struct Release {
    void operator()(Factored* factored) const;
  };
  std::unique_ptr<Factored, Release> factored_;
};

}  // namespace fretval::fem
