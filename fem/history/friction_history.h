#pragma once

#include <Eigen/Dense>

#include "fem/history/normal_history.h"

namespace fretval::fem {

/// Stick and slip of every ring, judged over the whole history and over the last period.
struct FrictionHistory {
  int n_cycles;                        ///< computed
  double periodicity;                  ///< reached, see HistoryControl
  Eigen::VectorXd first_slip_margin;   ///< per ring: smallest sample of `mu p - |tau|` from the start on
  Eigen::VectorXd shakedown_margin;    ///< per ring: `[min(mu p - tau) + min(mu p + tau)] / 2`, of the last period
  Eigen::VectorXd first_slip_reserve;  ///< per ring: smallest slip reserve of `mu p -+ tau` from the start on
  Eigen::VectorXd shakedown_reserve;   ///< per ring: mean of the smallest of either over the last period
  Eigen::VectorXd slip_path;           ///< per ring: length of slip from the start on
  Eigen::VectorXd period_slip;         ///< per ring: length of slip in the last period
  Eigen::VectorXd force;          ///< per instant of the whole history, the instants of the normal one continued; see
                                  ///< PunchSeries
  Eigen::VectorXd displacement;   ///< of the rings, at the end of the last period
  double dissipated_energy;       ///< by friction in the last period, see PunchSeries
  Eigen::VectorXd friction_work;  ///< per ring: by friction in the last period
  Eigen::MatrixXd traction;       ///< n_rings x steps per period: the last period
};

/// Steps Coulomb friction with unidirectional traction, |tau| <= mu p, through the motion from rest until the tractions
/// are periodic. Tangential contact problem and normal history must share the rings. Throws SolverError when the
/// tractions are not periodic after control.max_cycles.
FrictionHistory friction_history(const ContactProblem& problem, const RelaxationModel& relaxation,
                                 double friction_coefficient, const Motion& motion, const NormalHistory& normal,
                                 const HistoryControl& control);

}  // namespace fretval::fem
