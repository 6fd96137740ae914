#pragma once

#include <Eigen/Dense>
#include <optional>

#include "fem/full_contact/conjugate_gradients.h"
#include "fem/full_contact/surface_operator.h"

namespace fretval::fem {

/// Tractions within given friction limits, and their residual.
struct FrictionSolution {
  Eigen::MatrixXd traction;  ///< n_rings x 2 n_angles, t_x before t_y
  Eigen::MatrixXd residual;  ///< q - K t, zero where |t| < limit and along t elsewhere: areas times slip
  double remainder = 0;      ///< natural residual of the solution, over the largest limit
  int iterations = 0;        ///< iterations of Newton's method
  int applications = 0;      ///< applications of the operator
};

/// Friction with a traction of any direction: the one t that minimises
///
///   t . K t/2 - q . t    over the discs    |t| <= limit
///
/// of all points. K: a SurfaceOperator with tangential fields alone, symmetric positive definite. Where a point sticks,
/// q - K t vanishes; where it slips, q - K t points along t. (The box problem of fem/ring_contact/box_solver.h with
/// discs in the place of intervals; Duvaut and Lions, Inequalities in Mechanics and Physics, chapter III.)
///
/// Method: semismooth Newton on `t = P(t + rho (q - K t))`, P the projection onto the discs. A point that slips keeps
/// to the rim of its disc and moves along it, against the stiffness |q - K t|/limit of the curved rim. The linear
/// systems are solved by conjugate gradients, preconditioned with the inverse of K that is tied to the ground by the
/// mean of these stiffnesses over each ring, order by order. Where a point is stiffer than that mean, or has become so
/// since, the inverse is scaled by how much. A step goes to the projected iterate where that
/// halves the remainder. Where it does not, it goes as far towards it as lowers the energy, or along the projected
/// gradient if that lowers it by more: so every step makes at least the progress of a method that always converges. The
/// next linear system is solved ten times as far: a few points at the edge, where limits differ around a ring, may keep
/// their share of the residual while the rest loses it.
///
/// limit: n_rings x n_angles, not negative. pull: q. guess: any tractions to start from. `remainder` is the natural
/// residual of the solution that is returned, the largest |t - P(t + rho (q - K t))| with rho the inverse of the
/// diagonal of K, over the largest limit. Throws SolverError where it neither comes below `enough` nor, after the last
/// iteration, below 1e-10, and std::invalid_argument for sizes that do not fit and limits that are negative or no
/// numbers.
///
/// One solver serves one problem after another on an operator, such as those of a step: what a problem was
/// preconditioned with serves the next one, as long as that takes few applications.
class FrictionSolver {
 public:
  /// op: must outlive this.
  explicit FrictionSolver(const SurfaceOperator& op) : op_(&op) {}
  FrictionSolution solve(const Eigen::MatrixXd& pull, const Eigen::MatrixXd& limit, const Eigen::MatrixXd& guess,
                         double enough = enough_of_contact);

  /// An inverse of the operator on the rings that have a friction limit and some more, tied to the ground as they were
  /// once.
  struct Preconditioner {
    std::optional<InverseOperator> inverse;
    Eigen::ArrayXd stiffness;  ///< of its rings to the ground
    double per_decade = 0;     ///< applications of the operator for a tenth of a residual, when the inverse was new
    double n_more = 0;         ///< applications beyond that rate since
  };

 private:
  const SurfaceOperator* op_;
  std::optional<SurfaceOperator> touching_;  // on the rings that had a limit in the last problem
  Preconditioner preconditioner_;
};

/// The tractions, each replaced by the nearest one within its limit where it exceeds that.
Eigen::MatrixXd onto_discs(Eigen::MatrixXd traction, const Eigen::MatrixXd& limit);

/// The natural residual of FrictionSolver for any tractions, in their unit. residual: q - K t.
double friction_remainder(const SurfaceOperator& op, const Eigen::MatrixXd& residual, const Eigen::MatrixXd& limit,
                          const Eigen::MatrixXd& traction);

}  // namespace fretval::fem
