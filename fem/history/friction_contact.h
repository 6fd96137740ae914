#pragma once

#include <Eigen/Dense>
#include <optional>
#include <utility>
#include <vector>

#include "fem/history/normal_contact.h"
#include "fem/history/periodic_state.h"
#include "fem/motion/motion.h"
#include "fem/motion/relaxation.h"
#include "fem/ring_contact/contact_problem.h"
#include "fem/ring_contact/friction_force.h"
#include "fem/ring_contact/slip_zones.h"

namespace fretval::fem {

/// Coulomb friction with unidirectional traction, |tau| <= mu p, on its way through the motion beside a normal contact:
/// what it is like after the last step, and how it goes on. It begins at rest, without traction. Where a force is
/// prescribed, each step finds the displacement at which friction_force() balances it or, where no NormalInstant is
/// given, the sum over the rings does.
class FrictionContact {
 public:
  /// The problem shares its rings with that of the normal contact. All arguments must outlive this.
  FrictionContact(const ContactProblem& problem, const RelaxationModel& relaxation, double friction_coefficient,
                  const Motion& motion, int steps_per_cycle);

  /// Makes the next step under the ring pressures at its balance time. normal: what friction_force needs under a
  /// prescribed force. Throws GrossSlip where such a force reaches mu F_N.
  void step(const Eigen::Ref<const Eigen::VectorXd>& pressure, const std::optional<NormalInstant>& normal = {});

  long n_steps = 0;                 ///< steps made so far
  double displacement = 0;          ///< of the indenter at the end of the step
  double balance_displacement = 0;  ///< at the balance time
  Eigen::VectorXd limit;            ///< mu p
  Eigen::VectorXd limit_depths;     ///< mu p as depths of PunchSeries
  Eigen::VectorXd traction;         ///< at the balance time
  Eigen::VectorXd slip;             ///< of the rings in the whole last step
  Eigen::VectorXd slip_depths;      ///< slip as displacements of PunchSeries
  RingState state;                  ///< at the end of the step; may be changed between cycles only
  SlipZones zones;                  ///< how each ring moved last, and the depths of the traction

  [[nodiscard]] const ContactProblem& problem() const { return problem_; }
  [[nodiscard]] const RelaxationModel& relaxation() const { return relaxation_; }
  [[nodiscard]] const Motion& motion() const { return motion_; }
  [[nodiscard]] double friction_coefficient() const { return friction_coefficient_; }
  [[nodiscard]] int steps_per_cycle() const { return steps_per_cycle_; }
  /// Displacements of the rings at the balance time of the last step: those at its end less what they move by after the
  /// balance time.
  [[nodiscard]] auto balance_displacements() const {
    const double after = displacement - balance_displacement;
    return state.displacement + (1 - fraction()) * slip - Eigen::VectorXd::Constant(slip.size(), after);
  }
  /// Fraction of a step at which forces balance.
  [[nodiscard]] double fraction() const { return step_.fraction(); }
  /// The last step as FrozenStep: its relaxation, and the rings that stick.
  [[nodiscard]] FrozenStep frozen() const;
  /// Where the last step lies in its piece of a path, with its balance time as the sample; empty: the motion is made of
  /// cosines.
  [[nodiscard]] std::optional<StepInPiece> in_piece() const;

  /// All that the next step depends on, for a contact to which no NormalInstant is given. To be loaded into one that
  /// was made of the same arguments.
  template <class Archive>
  void serialize(Archive& archive) {
    archive(n_steps, displacement, balance_displacement, limit, limit_depths, traction, slip, state, zones, made_.stick,
            last_increment_, time_before_, spare_before_, largest_displacement_);
    if constexpr (Archive::is_loading::value) read_depths_of_state();
  }

 private:
  /// Result of a step in which the indenter makes a certain move up to the balance time.
  struct Attempt {
    std::vector<BoxState> stick;  // interior: sticks
    BoxSolver::Target target;
    BoxSolver::Solution solution;
    Eigen::VectorXd slip_to_touch;    // of rings that touch in the step, before they do
    Eigen::VectorXd depths_to_touch;  // slip_to_touch as displacements of PunchSeries
    Eigen::VectorXd depths;           // of the traction
  };
  /// made.stick: the likely states of the rings on entry, the states of the solution on exit.
  void attempt(const IndenterMove& to_balance, Attempt& made) const;
  struct Moves {
    IndenterMove to_balance, whole;
  };
  [[nodiscard]] Moves moves_in_step(double begin) const;
  /// Moves of the indenter in the next step.
  const Moves& moves();
  void read_depths_of_state();
  void find_touching(const Eigen::Ref<const Eigen::VectorXd>& pressure, const std::optional<NormalInstant>& normal);
  void slip_before_touch(Attempt& made) const;
  void foresee_slip(Attempt& made) const;
  [[nodiscard]] double force_of(const Attempt& made, const std::optional<NormalInstant>& normal) const;
  [[nodiscard]] std::pair<double, Attempt> attempt_under_force(double time, const std::optional<NormalInstant>& normal);

  const ContactProblem& problem_;
  const RelaxationModel& relaxation_;
  double friction_coefficient_;
  const Motion& motion_;
  int steps_per_cycle_;
  StepTimes times_;
  long n_steps_of_ramp_;
  double dt_;  // of the step that step_ is made for
  RelaxationStep step_;
  RingState depths_of_state_;        // state as displacements of PunchSeries, in which each step needs its response
  double largest_displacement_ = 0;  // largest of the indenter so far
  Moves moves_{};
  std::vector<std::optional<Moves>> moves_of_cycle_;  // known moves of the steps of a cycle that repeats
  Eigen::VectorXd least_;                             // -limit
  Attempt made_;                                      // in the last step
  double radius_before_ = 0;                          // of the contact
  Eigen::Index first_touching_ = 0, n_touching_ = 0;  // in the step
  Eigen::VectorXd until_touch_;                       // share of the step before these rings touch
  // For a prescribed force.
  std::optional<TouchingRings> touching_;
  double last_increment_ = 0;                  // of the displacement, in the last step
  double time_before_ = 0, spare_before_ = 0;  // time of the last balance, and what the force left of mu F_N then
};

}  // namespace fretval::fem
