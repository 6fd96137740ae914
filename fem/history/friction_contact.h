#pragma once

#include <Eigen/Dense>
#include <vector>

#include "fem/history/contact_problem.h"
#include "fem/history/motion.h"
#include "fem/history/relaxation.h"
#include "fem/history/slip_zones.h"

namespace fretval::fem {

/// Coulomb friction with unidirectional traction, |tau| <= mu p, on its way through the motion beside a normal contact:
/// what it is like after the last step, and how it goes on. It begins at rest, without traction.
class FrictionContact {
 public:
  /// The problem shares its rings with that of the normal contact. All arguments must outlive this.
  FrictionContact(const ContactProblem& problem, const RelaxationModel& relaxation, double friction_coefficient,
                  const Motion& motion, int steps_per_cycle);

  /// Goes on by a step under ring pressures at its balance time.
  void step(const Eigen::VectorXd& pressure);

  long n_steps = 0;              ///< made
  Eigen::VectorXd limit;         ///< mu p
  Eigen::VectorXd limit_depths;  ///< the same as depths of PunchSeries
  Eigen::VectorXd traction;      ///< at the balance time
  Eigen::VectorXd slip;          ///< in the whole step
  RingState state;               ///< at the end of the step
  SlipZones zones;               ///< the traction has kinks where these differ; with its depths

  [[nodiscard]] const ContactProblem& problem() const { return problem_; }
  [[nodiscard]] const RelaxationModel& relaxation() const { return relaxation_; }
  [[nodiscard]] const Motion& motion() const { return motion_; }
  [[nodiscard]] double friction_coefficient() const { return friction_coefficient_; }
  [[nodiscard]] int steps_per_cycle() const { return steps_per_cycle_; }
  /// Fraction of a step at which forces balance.
  [[nodiscard]] double fraction() const { return step_.fraction(); }

 private:
  const ContactProblem& problem_;
  const RelaxationModel& relaxation_;
  double friction_coefficient_;
  const Motion& motion_;
  int steps_per_cycle_;
  double dt_;
  RelaxationStep step_;
  std::vector<BoxState> stick_;  // interior: sticks
};

}  // namespace fretval::fem
