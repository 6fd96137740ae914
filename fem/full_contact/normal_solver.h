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
  int iterations = 0;        ///< iterations of the active set
};

/// Normal contact without or with given tractions: the one p >= 0 that minimises `p . K p/2 - q . p`, with K a
/// SurfaceOperator of the normal field alone. target: q, areas times the displacements into the body that would close
/// the gaps, less those by the tractions. (The box problem of fem/ring_contact/box_solver.h with an operator in the
/// place of a matrix.)
///
/// Method: primal-dual active set, in which all points whose pressure or gap has the wrong sign change at once, with
/// conjugate gradients for the pressures and the safeguards of FrictionSolver. guess: any pressures to start from.
/// Throws SolverError where the natural residual max |p - max(0, p + rho (q - K p))| does not come below `enough` of
/// the largest pressure, and std::invalid_argument for sizes that do not fit and a q that is not finite.
PressureSolution solve_pressure(const SurfaceOperator& op, const Eigen::MatrixXd& target, const Eigen::MatrixXd& guess);

/// Normal contact as above, with the inverse of the operator without a ground, which is made once where several
/// problems are solved.
PressureSolution solve_pressure(const SurfaceOperator& op, const InverseOperator& inverse,
                                const Eigen::MatrixXd& target, const Eigen::MatrixXd& guess,
                                double enough = enough_of_contact);

/// Normal contact with K + D in the place of K, where points also give way by themselves. softness: D, the area of a
/// point times its displacement per pressure, not negative, n_rings x n_angles. (For an indenter that wears it is the
/// depth that a pressure wears off.)
PressureSolution solve_pressure(const SurfaceOperator& op, const Eigen::MatrixXd& softness,
                                const Eigen::MatrixXd& target, const Eigen::MatrixXd& guess, double enough);

/// The natural residual of solve_pressure() for any pressures, over the largest of them. opened: K p - q, or (K + D) p
/// - q.
double pressure_remainder(const SurfaceOperator& op, const Eigen::MatrixXd& softness, const Eigen::MatrixXd& pressure,
                          const Eigen::MatrixXd& opened);

}  // namespace fretval::fem
