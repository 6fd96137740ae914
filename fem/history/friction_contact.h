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
/// prescribed, each step finds the displacement at which friction_force balances it or, of a normal contact that
/// nothing else is told of, the sum over the rings.
class FrictionContact {
 public:
  /// The problem shares its rings with that of the normal contact. All arguments must outlive this.
  FrictionContact(const ContactProblem& problem, const RelaxationModel& relaxation, double friction_coefficient,
                  const Motion& motion, int steps_per_cycle);

  /// Goes on by a step under ring pressures at its balance time. normal: what friction_force needs under a prescribed
  /// force. Throws GrossSlip where such a force reaches mu F_N.
  void step(const Eigen::Ref<const Eigen::VectorXd>& pressure, const std::optional<NormalInstant>& normal = {});

  long n_steps = 0;                 ///< made
  double displacement = 0;          ///< of the indenter at the end of the step
  double balance_displacement = 0;  ///< at the balance time
  Eigen::VectorXd limit;            ///< mu p
  Eigen::VectorXd limit_depths;     ///< the same as depths of PunchSeries
  Eigen::VectorXd traction;         ///< at the balance time
  Eigen::VectorXd slip;             ///< in the whole step
  Eigen::VectorXd slip_depths;      ///< the same as displacements of PunchSeries
  RingState state;                  ///< at the end of the step; to be changed between cycles alone
  SlipZones zones;                  ///< the traction has kinks where these differ; with its depths

  [[nodiscard]] const ContactProblem& problem() const { return problem_; }
  [[nodiscard]] const RelaxationModel& relaxation() const { return relaxation_; }
  [[nodiscard]] const Motion& motion() const { return motion_; }
  [[nodiscard]] double friction_coefficient() const { return friction_coefficient_; }
  [[nodiscard]] int steps_per_cycle() const { return steps_per_cycle_; }
  /// Of the rings at the balance time: what they do in a step after it is undone.
  [[nodiscard]] auto balance_displacements() const {
    const double after = displacement - balance_displacement;
    return state.displacement + (1 - fraction()) * slip - Eigen::VectorXd::Constant(slip.size(), after);
  }
  /// Fraction of a step at which forces balance.
  [[nodiscard]] double fraction() const { return step_.fraction(); }
  /// The last step, in which rings that stick are held.
  [[nodiscard]] FrozenStep frozen() const;
  /// Where the last step lies in its piece of a path, sampled at the balance time; empty: of cosines.
  [[nodiscard]] std::optional<StepInPiece> in_piece() const;

  /// What the next step depends on, of a contact that is told of no normal instants; into one that was made of the same
  /// arguments.
  template <class Archive>
  void serialize(Archive& archive) {
    archive(n_steps, displacement, balance_displacement, limit, limit_depths, traction, slip, state, zones, made_.stick,
            last_increment_, time_before_, spare_before_, largest_displacement_);
    if constexpr (Archive::is_loading::value) read_depths_of_state();
  }

 private:
  /// What a move of the indenter up to the balance time would come to.
  struct Attempt {
    std::vector<BoxState> stick;  // interior: sticks
    BoxSolver::Target target;
    BoxSolver::Solution solution;
    Eigen::VectorXd slip_to_touch;    // of rings that touch in the step, before they do
    Eigen::VectorXd depths_to_touch;  // the same as displacements of PunchSeries
    Eigen::VectorXd depths;           // of the traction
  };
  /// The stick of what is made: as likely on entry.
  void attempt(const IndenterMove& to_balance, Attempt& made) const;
  struct Moves {
    IndenterMove to_balance, whole;
  };
  [[nodiscard]] Moves moves_in_step(double begin) const;
  /// Of the next step.
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
  RingState depths_of_state_;        // as displacements of PunchSeries, which each step asks for of its response
  double largest_displacement_ = 0;  // of the indenter, so far
  Moves moves_{};
  std::vector<std::optional<Moves>> moves_of_cycle_;  // that repeats
  Eigen::VectorXd least_;                             // -limit
  Attempt made_;                                      // in the last step
  double radius_before_ = 0;                          // of the contact
  Eigen::Index first_touching_ = 0, n_touching_ = 0;  // in the step
  Eigen::VectorXd until_touch_;                       // of these, the share of it before they do
  // Under a prescribed force.
  std::optional<TouchingRings> touching_;
  double last_increment_ = 0;                  // of the displacement
  double time_before_ = 0, spare_before_ = 0;  // of the last balance, and what was left of mu F_N then
};

}  // namespace fretval::fem
