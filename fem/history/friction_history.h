#pragma once

#include <Eigen/Dense>
#include <functional>
#include <optional>
#include <vector>

#include "fem/history/friction_contact.h"
#include "fem/history/normal_history.h"
#include "fem/motion/running_minimum.h"

namespace fretval::fem {

/// Stick and slip of every ring, judged over the whole history and over the last period.
struct FrictionHistory {
  int n_cycles = 0;                    ///< computed
  long n_steps = 0;                    ///< computed
  int n_cycles_of_search = 0;          ///< beside them, to find the periodic state
  bool jumped = false;                 ///< to its periodic state, by a search or along its drift
  double periodicity = 0;              ///< reached, see HistoryControl
  Eigen::VectorXd first_slip_margin;   ///< per ring: smallest sample of `mu p - |tau|` from the start on
  Eigen::VectorXd shakedown_margin;    ///< per ring: `[min(mu p - tau) + min(mu p + tau)] / 2`, of the last period
  Eigen::VectorXd first_slip_reserve;  ///< per ring: smallest slip reserve of `mu p -+ tau` from the start on
  Eigen::VectorXd shakedown_reserve;   ///< per ring: mean of the smallest of either over the last period
  Eigen::VectorXd slip_path;           ///< per ring: length of slip from the start on
  Eigen::VectorXd period_slip;         ///< per ring: length of slip in the last period
  Eigen::VectorXd force;               ///< per step of the last period; see PunchSeries
  Eigen::VectorXd force_uncertainty;   ///< likewise, see FrictionForce
  Eigen::MatrixXd displacement;        ///< of the rings, per step of the last period, at the balance times
  Eigen::VectorXd indenter;            ///< its displacement, per step of the last period
  double amplitude = 0;                ///< of the indenter; under a force half of what lies between its extremes
  double dissipated_energy = 0;        ///< by friction in the last period, see PunchSeries
  double dissipated_uncertainty = 0;   ///< of that, see PunchSeries::Integral
  Eigen::VectorXd friction_work;       ///< per ring: by friction in the last period
  Eigen::MatrixXd traction;            ///< n_rings x steps per period: the last period
  std::vector<Eigen::VectorXd> slip_of_periods;  ///< per ring: length of slip in every period that was computed
};

/// Length of slip in a period up to which a ring counts as stuck: one that has shaken down still creeps a little while
/// its offset settles. amplitude: of the indenter, see FrictionHistory.
double slip_of_stuck_ring(const Motion& motion, double amplitude);

/// Watches one period: what still slips in it, its tractions, its energy.
class FrictionPeriod {
 public:
  FrictionPeriod(Eigen::Index n_rings, int n_steps);
  /// Forgets the period before, but for its last samples.
  void begin();
  void see(const FrictionContact& contact);
  /// Of a step of a period that nothing is reported of, nor of the next one: slips and tractions alone.
  void pass(const FrictionContact& contact);
  /// Reports what has been seen, and hands over the tractions and displacements that it has kept.
  void hand_over(const ContactProblem& problem, FrictionHistory& history);
  /// Largest change of a traction against the period before, over the largest one.
  [[nodiscard]] double change() const { return largest_traction_ == 0 ? 0 : largest_change_ / largest_traction_; }
  /// Amplitude of the indenter in this period, see FrictionHistory.
  [[nodiscard]] double amplitude(const Motion& motion) const;
  [[nodiscard]] const Eigen::MatrixXd& traction() const { return traction_; }
  [[nodiscard]] const Eigen::VectorXd& slip() const { return slip_; }
  /// See FrictionContact; a column a step.
  [[nodiscard]] const Eigen::MatrixXd& limit_depths() const { return limit_depths_; }

 private:
  // Smallest mu p - tau and mu p + tau. Of the samples: between them a parabola would dip to zero at a kink.
  Eigen::VectorXd forward_, backward_;
  Eigen::VectorXd slip_;
  Eigen::MatrixXd traction_, displacement_, depths_, limit_depths_;  // a column a step
  std::vector<std::optional<StepInPiece>> pieces_;                   // that they lie in
  Eigen::VectorXd indenter_;
  Eigen::VectorXd both_ways_;       // of the indenter, and the other way round
  RunningMinimum extremes_;         // of these
  std::vector<signed char> zones_;  // what happened to each ring, as bits
  Eigen::VectorXd last_traction_, last_depths_;
  Eigen::VectorXd work_, series_work_;  // of friction, per area, and as a product of depths and displacements
  double largest_change_ = 0, largest_traction_ = 0;
  // The last samples of the period before, at which minima still count.
  Eigen::MatrixXd depths_before_, limit_depths_before_;
  std::vector<std::optional<StepInPiece>> pieces_before_;
  int k_ = 0;

  [[nodiscard]] Eigen::VectorXd smallest_reserve(double direction) const;
};

/// Watches for the rings that have never slipped.
class FirstSlip {
 public:
  explicit FirstSlip(Eigen::Index n_rings);
  void see(const FrictionContact& contact);
  /// Its slip.
  void see_end_of(const FrictionPeriod& period) { slip_path_ += period.slip(); }
  void report(FrictionHistory& history) const;
  [[nodiscard]] const Eigen::VectorXd& slip_path() const { return slip_path_; }

 private:
  Eigen::VectorXd margin_;  // smallest mu p - |tau|, of the samples as in a period
  // Slip reserves of mu p - tau and mu p + tau. No floor under them: below zero between two samples they tell what a
  // finer step would have let slip.
  RunningMinimum forward_, backward_;
  Eigen::VectorXd slip_path_;
};

/// Friction beside a normal contact, with everything that is watched. As long as the normal contact is on its way to
/// its periodic state, step it with every step of that; then let friction_history go on.
class WatchedFriction {
 public:
  /// See FrictionContact.
  WatchedFriction(const ContactProblem& problem, const RelaxationModel& relaxation, double friction_coefficient,
                  const Motion& motion, int steps_per_cycle);
  void step(const Eigen::VectorXd& pressure, const std::optional<NormalInstant>& normal = {});
  /// Beside the normal contact, whose rings touch from the centre outwards, after its last step.
  void step_beside(const NormalContact& normal);

  FrictionContact contact;
  FirstSlip first_slip;
  FrictionPeriod period;
  Eigen::VectorXd slip_before;                   ///< of the period before
  std::vector<Eigen::VectorXd> slip_of_periods;  ///< see FrictionHistory

  [[nodiscard]] int period_steps() const { return contact.steps_per_cycle() * contact.motion().cycles_per_period(); }

 private:
  long n_steps_to_pass_;  // before the last period of the ramp
};

/// Periods of dozens of oscillations after which a history is given up. One of a body that creeps for longer has the
/// thousands of oscillations in them to settle.
constexpr int most_long_periods = 50;

/// Where rings touch in any order (NormalHistory::touches_in_order), force and energy are sums over the rings, and
/// rings that touch are held from the start of their step on.
///
/// A single pass is stepped beside its normal history, from rest. Otherwise:
/// Goes on under the repeating cycle of the normal contact until the tractions are periodic, and the innermost ring
/// that slips is not about to stick: its slip, dying out as from the last period but one to the last, would be that of
/// a stuck ring within as many periods again as there have been. Throws SolverError when they are not after
/// control.max_cycles or, under an unlocked phase, most_long_periods, which may be more. see: called after each step.
FrictionHistory friction_history(WatchedFriction friction, const NormalHistory& normal, const HistoryControl& control,
                                 const std::function<void(const FrictionContact&)>& see = {});

/// Both contacts from their start to their periodic states, side by side.
struct ContactHistory {
  NormalHistory normal;
  FrictionHistory friction;
};
ContactHistory contact_history(NormalContact normal, WatchedFriction friction, const HistoryControl& control);

/// Where the indenter does not move tangentially, nothing slips: a margin is the friction limit itself. problem: the
/// normal one; pressures: at the start, then after each step until they repeat.
FrictionHistory friction_at_rest(const ContactProblem& problem, double friction_coefficient,
                                 const std::vector<Eigen::VectorXd>& pressures, const NormalHistory& normal);

}  // namespace fretval::fem
