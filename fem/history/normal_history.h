#pragma once

#include <Eigen/Dense>
#include <functional>

#include "fem/history/normal_contact.h"

namespace fretval::fem {

/// How finely a history is computed, and when it counts as periodic.
struct HistoryControl {
  int steps_per_cycle = 180;
  int max_cycles = 400;
  /// Largest change of a ring force that is still to come, relative to the largest force (change_to_come).
  double periodicity = 1e-7;
};

/// The periodic state of the normal contact: the last cycle, which repeats, and how the history came to it.
struct NormalHistory {
  int steps_per_cycle = 0;
  int n_cycles = 0;                   ///< cycles computed; from the last one on, the response repeats
  int n_cycles_of_search = 0;         ///< further cycles in the search for the periodic state
  double periodicity = 0;             ///< reached, see HistoryControl
  double first_balance = 0;           ///< time at which forces balanced in the first step of all
  Eigen::VectorXd time;               ///< balance time of each step of the cycle, as for all values below
  Eigen::MatrixXd pressure;           ///< n_rings x steps_per_cycle
  Eigen::MatrixXd friction_pressure;  ///< see pressure_for_friction; empty: equal to pressure
  Eigen::MatrixXd pressure_depths;    ///< n_rings x steps_per_cycle, see NormalInstant; empty: not computed
  Eigen::VectorXd indentation;        ///< at the balance times
  double largest_indentation = 0;     ///< of the cycle, at the ends of the steps and between them
  Eigen::VectorXd force;              ///< of the contact around the centre, see contact_force
  Eigen::VectorXd force_uncertainty;  ///< see ContactForce
  Eigen::VectorXd force_beyond, force_beyond_uncertainty;  ///< of rings that press beyond a free one
  Eigen::VectorXd contact_radius;
  /// Per ring: the contact radius at which it touches, see PunchSeries::radii. Empty: rings touch in any order, and
  /// forces are sums over the rings (ForceReading::sum_of_rings).
  Eigen::VectorXd touch_radii;
  Eigen::VectorXd smallest_gap;  ///< per ring over the cycle; 0 for rings that touch
  /// Per ring: smallest gap over the cycle by a RunningMinimum of the gaps at the balance times; it agrees with
  /// smallest_gap to second order in the step.
  Eigen::VectorXd smallest_gap_at_balance;
  Eigen::VectorXd deepest_displacement;  ///< of the rings, at the largest indentation
  Eigen::MatrixXd displacement;          ///< of the rings, per step of the cycle, at the balance times
  std::vector<StepInPiece> pieces;       ///< of the steps of the cycle along a path; empty: cosines

  /// Column of a step in the cycle, counted from 1 for the first step of the history; from the last computed cycle on.
  [[nodiscard]] Eigen::Index column(long step) const { return (step - 1) % steps_per_cycle; }
  [[nodiscard]] bool touches_in_order() const { return touch_radii.size() > 0; }
  /// The pressures for the friction limit, n_rings x steps_per_cycle: friction_pressure if there is one, otherwise
  /// pressure.
  [[nodiscard]] const Eigen::MatrixXd& pressure_on_friction() const {
    return friction_pressure.size() > 0 ? friction_pressure : pressure;
  }
  /// The normal contact in a step of the cycle, as friction needs it. Empty: rings touch in any order.
  [[nodiscard]] std::optional<NormalInstant> instant(Eigen::Index column) const;
  [[nodiscard]] long n_steps() const { return static_cast<long>(n_cycles) * steps_per_cycle; }
};

/// Fills in friction_pressure for a tangential problem on the same rings.
void find_friction_pressure(const PunchSeries& normal, const PunchSeries& tangential, NormalHistory& history);

/// Called after each step of a normal contact, for what goes along with it: friction, or a record.
using Beside = std::function<void(const NormalContact&)>;

/// Steps a contact from its start until its response is periodic, or over the cycle of a single pass; beside is called
/// after each step. Where the body creeps slowly and no force is prescribed, the state that repeats is searched for
/// after the ramp, and the contact goes on from there; `beside` is not called in the cycles of the search. Throws
/// SolverError, with the measure reached, when the response is not periodic after max_cycles.
NormalHistory normal_history(NormalContact contact, const HistoryControl& control, const Beside& beside = {});

}  // namespace fretval::fem
