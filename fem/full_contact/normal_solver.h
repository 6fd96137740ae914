#pragma once

#include <Eigen/Dense>

#include "fem/full_contact/conjugate_gradients.h"
#include "fem/full_contact/surface_operator.h"

namespace fretval::fem {

/// Pressures on rings x angles, and the gaps that they leave.
struct PressureSolution {
  Eigen::MatrixXd pressure;  ///< n_rings x n_angles, not negative
  Eigen::MatrixXd residual;  ///< K p - q: areas times gaps, not negative, zero where there is a pressure
  double remainder = 0;      ///< natural residual of the solution, over the largest pressure
  int iterations = 0;        ///< of the active set
};

/// Normal contact without or with given tractions: the one p >= 0 that minimises `p . K p/2 - q . p`, K of
/// SurfaceOperator with the normal field alone. q: areas times the displacements into the body that would close the
/// gaps, less those by the tractions. (The box problem of fem/ring_contact/box_solver.h with an operator in the place
/// of a matrix.)
///
/// Method: primal-dual active set, all points whose pressure or gap has the wrong sign at once, with conjugate
/// gradients for the pressures, as in friction_solver.h, and the same safeguards. guess: of the pressures, any.
/// Throws SolverError where the natural residual max |p - max(0, p + rho (q - K p))| does not come below `enough` of
/// the largest pressure, and std::invalid_argument for sizes that do not fit and a q that is not finite.
PressureSolution solve_pressure(const SurfaceOperator& op, const Eigen::MatrixXd& target, const Eigen::MatrixXd& guess);

/// The same with the inverse of the operator without a ground, for one solution after the other.
PressureSolution solve_pressure(const SurfaceOperator& op, const InverseOperator& inverse,
                                const Eigen::MatrixXd& target, const Eigen::MatrixXd& guess,
                                double enough = enough_of_contact);

/// The same with K + D, of points that also give way by themselves: D is the area of a point times its displacement per
/// pressure, not negative, rings x angles. (Of an indenter that wears it is what a pressure takes off.)
PressureSolution solve_pressure(const SurfaceOperator& op, const Eigen::MatrixXd& softness,
                                const Eigen::MatrixXd& target, const Eigen::MatrixXd& guess, double enough);

/// The natural residual above, over the largest pressure. opened: K p - q, or (K + D) p - q.
double pressure_remainder(const SurfaceOperator& op, const Eigen::MatrixXd& softness, const Eigen::MatrixXd& pressure,
                          const Eigen::MatrixXd& opened);

}  // namespace fretval::fem
