#pragma once

#include <Eigen/Dense>
#include <vector>

#include "fem/support/shared_matrix.h"

namespace fretval::fem {

/// Where an unknown of a box-constrained problem sits.
enum class BoxState : signed char { lower = -1, interior = 0, upper = 1 };

/// Solves `find x in [lower, upper] minimising x.C x / 2 - q.x` for a symmetric positive definite C:
/// `(q - C x)_i` is zero in the interior, <= 0 at the lower and >= 0 at the upper bound. The solution is unique.
///
/// With lower = 0, upper = infinity it is the normal contact problem (x = pressure); with -mu p, +mu p the Coulomb
/// friction problem of one step. Unknowns are ordered from the centre of the contact outwards, so the interior set is
/// mostly a leading block {0..k-1}. With C = L L^T a leading interior needs no other factor: the loads `y = L^T x` of
/// the interior are those of `held = L^-1 q`, the others follow from the bounds, and `q - C x = L (held - y)`. As any
/// leading block of L^-1 is the inverse of the leading block of L, all of this is products with triangles, which unlike
/// substitutions need not wait for one unknown after the other.
///
/// Method: primal-dual active set (all violated unknowns change at once), warm-started; if the number of violations
/// does not decrease for several iterations, single changes by least index (Murty), which end after finitely many
/// steps.
class BoxSolver {
 public:
  /// slack: by how much a bound may be crossed, over the largest unknown (or residual), before the unknown changes its
  /// state: it keeps roundoff from moving one that sits exactly at its limit back and forth.
  /// Throws SolverError if C is not positive definite.
  explicit BoxSolver(SharedMatrix matrix, double slack = 1e-13);

  /// The solver of a problem with a diagonal added to C. added: the diagonal, not negative. The factor is taken over up
  /// to the first entry that is not 0, and is made for the first n_likely unknowns only; the others are supposed to be
  /// at their bounds. Slacks are judged in the problem scaled to a unit diagonal: an unknown with a large added entry
  /// is next to nothing, and has to have its sign all the same.
  BoxSolver(const BoxSolver& other, const Eigen::VectorXd& added, Eigen::Index n_likely);

  /// A right-hand side q, and held = L^-1 q: the loads L^T x if no unknown were at a bound, with L of factor().
  struct Target {
    Eigen::VectorXd q, held;
  };
  /// Sets `held` of a target from its q, unless a diagonal was added. Throws std::invalid_argument where q is not
  /// finite.
  void hold(Target& target) const;

  struct Solution {
    Eigen::VectorXd x;
    Eigen::VectorXd residual;  ///< q - C x; exactly 0 in the interior
    Eigen::VectorXd loads;     ///< L^T x, unless a diagonal was added
    int iterations = 0;
  };

  /// state: warm start on entry, the state of the solution on exit. Unknowns with lower = upper are fixed. solution:
  /// the result, written into the memory that it has. Throws SolverError if the iteration limit is reached or the
  /// solution does not fulfil its equations, and std::invalid_argument for bounds that are no numbers.
  void solve(const Target& target, const Eigen::VectorXd& lower, const Eigen::VectorXd& upper,
             std::vector<BoxState>& state, Solution& solution) const;
  Solution solve(const Eigen::VectorXd& q, const Eigen::VectorXd& lower, const Eigen::VectorXd& upper,
                 std::vector<BoxState>& state) const;

  [[nodiscard]] Eigen::Index size() const { return matrix_->rows(); }
  /// Lower Cholesky factor of C, or of its leading block that is likely to be needed.
  [[nodiscard]] const SharedMatrix& factor() const { return factor_; }
  /// The inverse of the factor; empty where a diagonal was added.
  [[nodiscard]] const SharedMatrix& inverse() const { return inverse_; }

 private:
  void solve_leading_interior(const Target& target, Eigen::Index k, Solution& solution) const;
  void solve_any_interior(const Eigen::VectorXd& q, const std::vector<Eigen::Index>& interior, Eigen::Index k,
                          Solution& solution) const;
  void solve_interior(const std::vector<Eigen::Index>& interior, Eigen::Index k, Eigen::VectorXd& x) const;

  void check(const Eigen::VectorXd& q, const Solution& solution) const;

  SharedMatrix matrix_;
  SharedMatrix factor_;                // lower Cholesky factor
  SharedMatrix inverse_;               // of the factor; empty where a diagonal was added, which soon changes
  Eigen::VectorXd probe_, image_;      // a vector to test solutions with, and its product with the matrix
  Eigen::VectorXd added_;              // added to the diagonal of the matrix; empty: nothing
  Eigen::VectorXd scale_, per_scale_;  // of the unknowns, and its inverse
  double slack_;
};

}  // namespace fretval::fem
