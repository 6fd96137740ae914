#pragma once

#include <Eigen/Dense>
#include <optional>
#include <string>
#include <vector>

#include "fem/condensation/sparse_factor.h"
#include "fem/operators/harmonic_space.h"
#include "fem/ring_contact/box_solver.h"

namespace fretval::fem {

/// Whether a sparse factor is kept as long as the set of interior rings stays the same, or made anew in every
/// iteration, as in a code that takes no account of that.
enum class SparseFactors { kept, made_anew };

/// What a history of sparse solves costs.
struct SolveCount {
  unsigned n_dofs = 0;  ///< dofs of the body; the sparse systems have n_rings more unknowns
  int n_factorisations = 0;
  int n_solves = 0;
};

/// Solves the contact (or friction) problem of BoxSolver with every degree of freedom of the body as an unknown: find
/// the field x and the ring tractions p in [lower, upper] with `K x + force = B p`, K the stiffness at unit shear
/// modulus and B the ring loads. The residual of a ring, its target less the mean of x over it, is zero in the
/// interior,
/// <= 0 at the lower and >= 0 at the upper bound.
///
/// Rings in the interior are held at their targets by their tractions as multipliers: `[K, -B; -B^T, 0]`; the tractions
/// of the others are at their bounds, with 1 on the diagonal of an otherwise empty row, so that all active sets share
/// one sparsity structure. Method: primal-dual active set (all violated rings change at once), warm-started; one
/// sparse factorisation whenever the interior differs from the last one factored, or in every iteration.
class BorderedSolver {
 public:
  /// name: the problem, for error messages.
  BorderedSolver(const HarmonicSpace& space, std::string name, SparseFactors factors = SparseFactors::kept);

  struct Solution {
    Eigen::VectorXd field;     ///< x, n_dofs; shear modulus times displacement
    Eigen::VectorXd traction;  ///< p, n_rings
    Eigen::VectorXd residual;  ///< n_rings; exactly 0 in the interior
  };

  /// force: n_dofs, 0 on constrained dofs; target: n_rings; state: warm start on entry, the state of the solution on
  /// exit. Rings with lower = upper are fixed. Throws SolverError if a solve fails or if the active set does not
  /// settle.
  Solution solve(const Eigen::VectorXd& force, const Eigen::VectorXd& target, const Eigen::VectorXd& lower,
                 const Eigen::VectorXd& upper, std::vector<BoxState>& state);

  [[nodiscard]] Eigen::VectorXd ring_means(const Eigen::VectorXd& field) const;
  [[nodiscard]] Eigen::Index n_rings() const { return line_.n_elements(); }
  [[nodiscard]] const SolveCount& count() const { return count_; }

 private:
  void factorise(const std::vector<bool>& interior);
  Solution solve_rings(const Eigen::VectorXd& force, const Eigen::VectorXd& target, const Eigen::VectorXd& at_bounds,
                       const std::vector<bool>& interior);

  ContactLine line_;
  SparseMatrix stiffness_;
  std::string name_;
  SparseFactors factors_;
  std::vector<bool> factored_;  // the interior that was factored last
  std::optional<SparseFactor> factor_;
  SolveCount count_;
};

}  // namespace fretval::fem
