#pragma once

#include <Eigen/Dense>
#include <functional>
#include <optional>

#include "fem/contact/force_balance.h"
#include "fem/full_contact/friction_solver.h"
#include "fem/full_contact/surface_operator.h"
#include "fem/motion/motion.h"
#include "fem/motion/relaxation.h"

namespace fretval::fem {

/// Where something is at a time t, in dimensionless time in which a cycle lasts 2 pi, and how fast: of two rates at a
/// kink, the one at the side of an instant inside the step.
using Course = std::function<ValueAndRate(double t, double inside)>;

/// How near forces that are prescribed come to their values, over the largest that friction bears, and by how much of
/// the unit of displacements their stiffness is measured.
constexpr double enough_of_force = 1e-9, probe_of_force = 1e-4;

/// Motion of the indenter along the surface.
struct LateralMotion {
  Course x, y;
  bool by_force = false;  ///< they are F_x and F_y, which the indenter follows at the balance time of each step
};
/// The motion must outlive it.
LateralMotion lateral_motion(const Motion& motion);

/// In a step that is no longer than a straight piece of the way or is curved smoothly.
IndenterMove move_in(const Course& course, double begin, double end, double inside);

/// Coulomb friction with a traction of any direction, |t| <= mu p, on its way through a motion: what it is like after
/// the last step, and how it goes on. It begins at rest, without traction.
///
/// A step is that of the unidirectional FrictionContact with discs in the place of intervals: with the response of what
/// does not slip, w (RelaxationStep), and the slip in the step, s, of each point
///
///   K t = areas (w - instantaneous s),    s = 0 or s along t and |t| = mu p,
///
/// so that the memory of the body is exact for points that stick. Points that touch in a step are held from its start
/// on. Fields have a row a ring and a column an angle, x before y.
class VectorFriction {
 public:
  /// op: of tangential fields. It and the motion must outlive this.
  VectorFriction(const SurfaceOperator& op, RelaxationModel relaxation, double friction_coefficient,
                 const LateralMotion& motion, StepTimes times);

  /// Goes on by a step under pressures at its balance time, of points or the same around each ring. Throws GrossSlip
  /// where a force that is prescribed reaches mu F_N.
  void step(const Eigen::MatrixXd& pressure);
  void step(const Eigen::VectorXd& ring_pressure);

  /// What the next step comes to under pressures to which the body also responds by so much along the surface, times
  /// the areas; until accept() nothing has changed but the limit and the guess for the next attempt. along: how far the
  /// indenter goes in the whole step in the directions whose forces are prescribed, n_forces of them.
  const FrictionSolution& attempt(const Eigen::MatrixXd& pressure, const Eigen::MatrixXd& displaced, double enough,
                                  const Eigen::VectorXd& along);
  /// Makes the step of the last attempt.
  void accept();

  /// How many forces the indenter follows: F_x, and F_y as well where no mirror balances it.
  [[nodiscard]] Eigen::Index n_forces() const;
  /// Those that are prescribed at the balance time of the next step. Throws GrossSlip where the limit of the last
  /// attempt does not bear them.
  Eigen::VectorXd prescribed_forces();
  /// Those of the last attempt.
  [[nodiscard]] Eigen::VectorXd attempted_forces() const;
  /// The largest tangential force that the limit bears.
  [[nodiscard]] double most_force() const { return (op_.areas().transpose() * limit).sum(); }

  /// Before the first step: displacements at rest, as of a body that is pressed without friction.
  void start_from(const Eigen::MatrixXd& displacement);

  long n_steps = 0;                           ///< made
  Eigen::Vector2d displacement, increment;    ///< of the indenter at the end of the step, and in it
  Eigen::MatrixXd limit;                      ///< mu p
  Eigen::MatrixXd traction, traction_before;  ///< at the balance times of this and of the last step
  Eigen::MatrixXd slip;                       ///< in the whole step
  int n_iterations = 0, n_applications = 0;   ///< that the step took

  [[nodiscard]] const SurfaceOperator& op() const { return op_; }
  [[nodiscard]] int steps_per_cycle() const { return times_.steps_per_cycle(); }
  /// Of the last step, or of the first one before it.
  [[nodiscard]] double fraction() const { return step_.fraction(); }
  [[nodiscard]] double instantaneous() const { return step_.instantaneous(); }  ///< likewise
  /// The next step.
  struct NextStep {
    double begin, balance, end;
    const RelaxationStep& relaxation;
    [[nodiscard]] double inside() const { return (begin + end) / 2; }
  };
  NextStep next_step();
  /// Where the last step lies in its piece of a path, sampled at the balance time; empty: of cosines.
  [[nodiscard]] std::optional<StepInPiece> in_piece() const;
  /// What the last step solved for: areas times the displacements that would leave no slip.
  [[nodiscard]] Eigen::MatrixXd pull() const;
  /// Of the points at the end of the step.
  [[nodiscard]] Eigen::MatrixXd displacements() const;

  /// F_x, F_y and the torque about the axis that the indenter exerts at the balance time. What a mirror leaves out
  /// balances F_y and the torque.
  [[nodiscard]] Eigen::Vector3d forces() const;
  /// Work of friction in the step, of second order: slip is made at a constant rate, so it meets the traction in the
  /// middle of the step, between those at the balance times of this step and the one before.
  [[nodiscard]] double friction_work() const { return friction_work_of_points().sum(); }
  [[nodiscard]] Eigen::MatrixXd friction_work_of_points() const;

  /// What the next step depends on; into a friction that was made of the same arguments.
  template <class Archive>
  void serialize(Archive& archive) {
    archive(n_steps, displacement, increment, limit, traction, traction_before, slip, x_, y_, solution_.traction,
            balance_.displacements, balance_.stiffness);
  }

 private:
  const SurfaceOperator& op_;
  RelaxationModel relaxation_;
  double friction_coefficient_;
  const LateralMotion& motion_;
  StepTimes times_;
  double dt_;  // of the step that step_ is made for
  RelaxationStep step_;
  RingState x_, y_;
  FrictionSolution solution_;
  /// Of the indenter in the step that is attempted.
  struct Moves {
    IndenterMove x_to_balance, y_to_balance, x, y;
  };
  [[nodiscard]] Moves moves_in(const NextStep& next, const Eigen::VectorXd& along) const;
  Moves moves_{};
  BalanceOfForces balance_;  // of the last step under a force
  Eigen::VectorXd arms_;     // mean distances of the rings from the axis
};

}  // namespace fretval::fem
