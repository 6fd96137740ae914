#pragma once

#include <Eigen/Dense>
#include <functional>

#include "fem/history/contact_problem.h"
#include "fem/history/motion.h"
#include "fem/history/relaxation.h"

namespace fretval::fem {

/// How finely a history is computed, and when it counts as periodic.
struct HistoryControl {
  int steps_per_cycle = 180;
  int max_cycles = 400;
  /// Largest change of a ring force that is still to come, relative to the largest force (change_to_come).
  double periodicity = 1e-7;
};

/// The normal contact problem through the ramp and on until its response is periodic. Ring pressures are unaffected by
/// the tangential motion (nu = 1/2), so one normal history serves all tangential motions.
struct NormalHistory {
  int steps_per_cycle = 0;
  int n_cycles = 0;                       ///< computed; from the last one on, the response repeats
  double periodicity = 0;                 ///< reached, see HistoryControl
  Eigen::VectorXd time;                   ///< per instant: 0, then the balance time of each step
  Eigen::MatrixXd pressure;               ///< n_rings x n_instants
  Eigen::VectorXd indentation;            ///< per instant
  Eigen::VectorXd force;                  ///< per instant, see contact_force
  Eigen::VectorXd force_uncertainty;      ///< per instant, see ContactForce
  Eigen::VectorXd kink_uncertainty;       ///< per instant, see ContactForce
  Eigen::VectorX<Eigen::Index> n_closed;  ///< per instant, see ContactForce
  Eigen::VectorXd contact_radius;         ///< per instant
  Eigen::VectorXd touch_radii;            ///< of the contact when a ring touches, see PunchSeries::radii
  Eigen::VectorXd smallest_gap;           ///< per ring over the last cycle; 0 for rings that touch
  /// The same from the gaps at the balance times, a parabola through three of them; both agree to second order.
  Eigen::VectorXd smallest_gap_at_balance;
  Eigen::VectorXd deepest_displacement;  ///< of the rings, at the largest indentation of the last cycle
  Eigen::VectorXd highest_displacement;  ///< of the rings, at the smallest indentation of the last cycle

  /// Column of `pressure` at a step counted from the start of the history, also beyond the computed ones.
  [[nodiscard]] Eigen::Index column(long step) const;
};

/// Mean over each ring of a profile f(r).
Eigen::VectorXd ring_means(const Compliance& compliance, const std::function<double(double)>& f);

/// Elastic normal contact with unit shear modulus at a fixed indentation; profile: ring means.
/// Returns the ring pressures and the remaining gaps.
struct NormalContact {
  Eigen::VectorXd pressure, gap;
};
NormalContact normal_contact(const ContactProblem& problem, const Eigen::VectorXd& profile, double indentation);

/// Throws SolverError when the response is not periodic after max_cycles (message with the measure reached) or when the
/// contact reaches the last ring of the line.
NormalHistory normal_history(const ContactProblem& problem, const RelaxationModel& relaxation,
                             const Eigen::VectorXd& profile, const Motion& motion, const HistoryControl& control);

}  // namespace fretval::fem
