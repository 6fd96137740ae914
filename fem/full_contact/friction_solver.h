#pragma once

#include <Eigen/Dense>

#include "fem/full_contact/conjugate_gradients.h"
#include "fem/full_contact/surface_operator.h"

namespace fretval::fem {

/// Tractions under given friction limits, and what is left of the pull on them.
struct FrictionSolution {
  Eigen::MatrixXd traction;  ///< n_rings x 2 n_angles, t_x before t_y
  Eigen::MatrixXd residual;  ///< q - K t, zero where |t| < limit and along t elsewhere: areas times slip
  double remainder = 0;      ///< natural residual of the solution, over the largest limit
  int iterations = 0;        ///< of Newton's method
  int applications = 0;      ///< of the operator
};

/// Friction with a traction of any direction: the one t that minimises
///
///   t . K t/2 - q . t    over the discs    |t| <= limit
///
/// of all points. K: of SurfaceOperator with tangential fields alone, symmetric positive definite. Where a point
/// sticks, (q - K t) vanishes; where it slips, it points along t. (The box problem of fem/ring_contact/box_solver.h
/// with discs in the place of intervals; Duvaut and Lions, Inequalities in Mechanics and Physics, chapter III.)
///
/// Method: semismooth Newton on `t = P(t + rho (q - K t))`, P the projection onto the discs. A point that slips keeps
/// to the rim of its disc and moves along it, against the stiffness |q - K t|/limit of the curved rim. The linear
/// systems are solved by conjugate gradients, preconditioned with the inverse of K that is tied to the ground by the
/// mean of these stiffnesses over each ring, order by order. A step goes to the projected iterate where that
/// halves the remainder. Where it does not, it goes as far towards it as lowers the energy, or along the projected
/// gradient if that lowers it by more: so every step makes at least the progress of a method that always converges.
///
/// limit: n_rings x n_angles, not negative. guess: of the tractions, any. The natural residual, the largest
/// |t - P(t + rho (q - K t))| with rho the inverse of the diagonal, is computed of the solution that is returned.
/// Throws SolverError where it neither comes below `enough` of the largest limit nor, after the last iteration, below
/// 1e-10, and std::invalid_argument for sizes that do not fit and limits that are negative or no numbers.
FrictionSolution solve_friction(const SurfaceOperator& op, const Eigen::MatrixXd& pull, const Eigen::MatrixXd& limit,
                                const Eigen::MatrixXd& guess, double enough = enough_of_contact);

/// Each traction, or the nearest one within its limit.
Eigen::MatrixXd onto_discs(Eigen::MatrixXd traction, const Eigen::MatrixXd& limit);

/// The natural residual above, for any tractions.
double friction_remainder(const SurfaceOperator& op, const Eigen::MatrixXd& residual, const Eigen::MatrixXd& limit,
                          const Eigen::MatrixXd& traction);

}  // namespace fretval::fem
