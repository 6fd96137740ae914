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
  int n_cycles = 0;                    ///< cycles computed
  long n_steps = 0;                    ///< steps computed
  int n_cycles_of_search = 0;          ///< further cycles in the search for the periodic state
  bool jumped = false;                 ///< whether a search or a jump has moved the state
  double periodicity = 0;              ///< reached, see HistoryControl
  Eigen::VectorXd first_slip_margin;   ///< per ring: smallest sample of `mu p - |tau|` from the start on
  Eigen::VectorXd shakedown_margin;    ///< per ring: `[min(mu p - tau) + min(mu p + tau)] / 2`, of the last period
  Eigen::VectorXd first_slip_reserve;  ///< per ring: smallest slip reserve of `mu p -+ tau` from the start on
  Eigen::VectorXd shakedown_reserve;   ///< per ring: mean of the smallest two reserves, of the last period
  Eigen::VectorXd slip_path;           ///< per ring: length of slip from the start on
  Eigen::VectorXd period_slip;         ///< per ring: length of slip in the last period
  Eigen::VectorXd force;               ///< per step of the last period; see PunchSeries
  Eigen::VectorXd force_uncertainty;   ///< of force, see FrictionForce
  Eigen::VectorXd force_off_by_steps;  ///< per step of the last period, see force_off_by_sliding_ends
  Eigen::MatrixXd displacement;        ///< of the rings, per step of the last period, at the balance times
  Eigen::VectorXd indenter;            ///< displacement of the indenter, per step of the last period
  double amplitude = 0;                ///< of the indenter; under a force half the range of its displacement
  double dissipated_energy = 0;        ///< by friction in the last period, see PunchSeries
  double dissipated_uncertainty = 0;   ///< of dissipated_energy, see PunchSeries::Integral
  Eigen::VectorXd friction_work;       ///< per ring: by friction in the last period
  double unseen_slip_energy = 0;       ///< in an oscillation, where no ring slips: see unseen_slip_energy
  Eigen::MatrixXd traction;            ///< n_rings x steps per period: the last period
  std::vector<Eigen::VectorXd> slip_of_periods;  ///< per ring: length of slip in every period that was computed
};

/// Length of slip in a period up to which a ring counts as stuck: a ring that has shaken down still slips a little
/// while its locked-in traction settles. amplitude: FrictionHistory::amplitude.
double slip_of_stuck_ring(const Motion& motion, double amplitude);

/// Records one period of friction: slips, tractions and dissipated energy.
class FrictionPeriod {
 public:
  FrictionPeriod(Eigen::Index n_rings, int n_steps);
  /// Forgets the period before, but for its last samples.
  void begin();
  void see(const FrictionContact& contact);
  /// Records slips and tractions alone: enough for a step of a period if neither that period nor the next one is
  /// reported.
  void pass(const FrictionContact& contact);
  /// Writes the record of the period into a history, which takes over the tractions and displacements.
  void hand_over(const ContactProblem& problem, FrictionHistory& history);
  /// Largest change of a traction since the period before, over the largest traction.
  [[nodiscard]] double change() const { return largest_traction_ == 0 ? 0 : largest_change_ / largest_traction_; }
  /// Amplitude of the indenter in this period, see FrictionHistory.
  [[nodiscard]] double amplitude(const Motion& motion) const;
  [[nodiscard]] const Eigen::MatrixXd& traction() const { return traction_; }
  [[nodiscard]] const Eigen::VectorXd& slip() const { return slip_; }
  /// Depths of the traction and FrictionContact::limit_depths, a column for each step.
  [[nodiscard]] const Eigen::MatrixXd& depths() const { return depths_; }
  [[nodiscard]] const Eigen::MatrixXd& limit_depths() const { return limit_depths_; }

 private:
  // Smallest samples of mu p - tau and mu p + tau: nothing is put between them, as a parabola would dip to zero at a
  // kink.
  Eigen::VectorXd forward_, backward_;
  Eigen::VectorXd slip_;
  Eigen::MatrixXd traction_, displacement_, depths_, limit_depths_;  // a column a step
  std::vector<std::optional<StepInPiece>> pieces_;                   // in which the steps lie
  Eigen::VectorXd indenter_;
  Eigen::VectorXd both_ways_;       // displacement of the indenter, and its negative
  RunningMinimum extremes_;         // smallest values of both_ways_
  std::vector<signed char> zones_;  // what happened to each ring, as bits
  Eigen::VectorXd last_traction_, last_depths_;
  Eigen::VectorXd work_, series_work_;  // of friction, per area, and as a product of depths and displacements
  double largest_change_ = 0, largest_traction_ = 0;
  // The last samples of the period before, next to which a minimum may lie that counts in this period.
  Eigen::MatrixXd depths_before_, limit_depths_before_;
  std::vector<std::optional<StepInPiece>> pieces_before_;
  int k_ = 0;

  [[nodiscard]] Eigen::VectorXd smallest_reserve(double direction) const;
};

/// Records from the start on which rings have never slipped.
class FirstSlip {
 public:
  explicit FirstSlip(Eigen::Index n_rings);
  void see(const FrictionContact& contact);
  /// Adds the slip of a period that has ended.
  void see_end_of(const FrictionPeriod& period) { slip_path_ += period.slip(); }
  void report(FrictionHistory& history) const;
  [[nodiscard]] const Eigen::VectorXd& slip_path() const { return slip_path_; }

 private:
  Eigen::VectorXd margin_;  // smallest sample of mu p - |tau|
  // Slip reserves of mu p - tau and mu p + tau. They have no floor: a value below zero between two samples shows a ring
  // that would have slipped with a finer step.
  RunningMinimum forward_, backward_;
  Eigen::VectorXd slip_path_;
};

/// Friction beside a normal contact, with the records of it. It is to be stepped with each step of the normal contact
/// until that is periodic; friction_history() goes on from there.
class WatchedFriction {
 public:
  /// Arguments as of FrictionContact.
  WatchedFriction(const ContactProblem& problem, const RelaxationModel& relaxation, double friction_coefficient,
                  const Motion& motion, int steps_per_cycle);
  void step(const Eigen::VectorXd& pressure, const std::optional<NormalInstant>& normal = {});
  /// Makes the step that the normal contact has just made; its rings touch from the centre outwards.
  void step_beside(const NormalContact& normal);

  FrictionContact contact;
  FirstSlip first_slip;
  FrictionPeriod period;
  Eigen::VectorXd slip_before;                   ///< per ring: length of slip in the period before
  std::vector<Eigen::VectorXd> slip_of_periods;  ///< see FrictionHistory

  [[nodiscard]] int period_steps() const { return contact.steps_per_cycle() * contact.motion().cycles_per_period(); }

 private:
  long n_steps_to_pass_;  // steps before the last period of the ramp, of which slips and tractions alone are recorded
};

/// Periods of dozens of oscillations each (of an unlocked phase) after which a history is given up. They hold thousands
/// of oscillations, in which also a body that creeps for long settles.
constexpr int most_long_periods = 50;

/// Where rings touch in any order (not NormalHistory::touches_in_order), force and energy are sums over the rings, and
/// rings that touch are held from the start of their step on.
///
/// A single pass is stepped beside its normal history, from rest. Otherwise friction goes on under the repeating cycle
/// of the normal contact until the tractions are periodic, and the innermost ring that slips is not about to stick. It
/// is about to stick if its slip, falling on as from the last period but one to the last, would be that of a stuck ring
/// within as many further periods as there have been. Throws SolverError when the tractions are not periodic after
/// control.max_cycles or, under an unlocked phase, after most_long_periods, which may be more cycles. see: called after
/// each step.
FrictionHistory friction_history(WatchedFriction friction, const NormalHistory& normal, const HistoryControl& control,
                                 const std::function<void(const FrictionContact&)>& see = {});

/// Histories of a normal contact and of the friction beside it, from their start to their periodic states.
struct ContactHistory {
  NormalHistory normal;
  FrictionHistory friction;
};
ContactHistory contact_history(NormalContact normal, WatchedFriction friction, const HistoryControl& control);

/// The history of friction where the indenter does not move tangentially: nothing slips, and the margin is the friction
/// limit itself. problem: that of the normal contact; pressures: of the rings at the start, then after each step until
/// they repeat.
FrictionHistory friction_at_rest(const ContactProblem& problem, double friction_coefficient,
                                 const std::vector<Eigen::VectorXd>& pressures, const NormalHistory& normal);

}  // namespace fretval::fem
