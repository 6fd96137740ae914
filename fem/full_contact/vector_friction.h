#pragma once

#include <Eigen/Dense>
#include <functional>
#include <optional>

#include "fem/contact/force_balance.h"
#include "fem/full_contact/expected_course.h"
#include "fem/full_contact/friction_solver.h"
#include "fem/full_contact/surface_operator.h"
#include "fem/motion/motion.h"
#include "fem/motion/relaxation.h"

namespace fretval::fem {

/// Position and rate at a dimensionless time t, in which a cycle lasts 2 pi. At a kink, which has two rates, the rate
/// is that on the side of `inside`, an instant within the step.
using Course = std::function<ValueAndRate(double t, double inside)>;

/// Accuracy of prescribed forces, over the largest force that friction bears, and the displacement by which their
/// stiffness is measured, in the unit of displacements.
constexpr double enough_of_force = 1e-9, probe_of_force = 1e-4;

/// Motion of the indenter along the surface.
struct LateralMotion {
  Course x, y;
  bool by_force = false;  ///< x and y are F_x and F_y, which the indenter follows at the balance time of each step
};
/// Motion along the surface as prescribed by a Motion, which must outlive it.
LateralMotion lateral_motion(const Motion& motion);

/// Move along a course from begin to end, between which it is straight or smooth; inside: an instant in between.
IndenterMove move_in(const Course& course, double begin, double end, double inside);

/// Coulomb friction with a traction of any direction, |t| <= mu p, on its way through a motion: what it is like after
/// the last step, and how it goes on. It begins at rest, without traction.
///
/// A step is that of the unidirectional FrictionContact with discs in the place of intervals: with the response of what
/// does not slip, w (RelaxationStep), and the slip in the step, s, of each point
///
///   K t = areas (w - instantaneous (s + s')),    s = 0 or s along t and |t| = mu p,
///
/// so that the memory of the body is exact for points that stick. s' is the part of the slip that is due to the turning
/// of the traction, by the step before (turning_slip), which makes steps of second order. Points that touch in a step
/// are held from its start on. Fields have a row for each ring and a column for each angle, x before y.
class VectorFriction {
 public:
  /// op: operator of tangential fields. It and the motion must outlive this.
  VectorFriction(const SurfaceOperator& op, RelaxationModel relaxation, double friction_coefficient,
                 const LateralMotion& motion, StepTimes times);

  /// Makes the next step under the pressures at its balance time, of points (n_rings x n_angles) or uniform around each
  /// ring (n_rings). Throws GrossSlip where a force that is prescribed reaches mu F_N.
  void step(const Eigen::MatrixXd& pressure);
  void step(const Eigen::VectorXd& ring_pressure);

  /// Solves the next step under pressures by which the body is displaced along the surface, too. displaced: these
  /// displacements times the areas (n_rings x 2 n_angles). Until accept() only the limit and the guess for the next
  /// attempt change. along: displacement of the indenter in the whole step in the n_forces() directions whose forces
  /// are prescribed.
  const FrictionSolution& attempt(const Eigen::MatrixXd& pressure, const Eigen::MatrixXd& displaced, double enough,
                                  const Eigen::VectorXd& along);
  /// Makes the step of the last attempt.
  void accept();
  /// The tractions with which the next attempt begins: those of the last one or, at the start of a step, those that are
  /// expected (ExpectedCourse).
  [[nodiscard]] const Eigen::MatrixXd& expected_traction() const { return guess_; }

  /// Number of prescribed forces along the surface: F_x, and F_y as well where no mirror balances it.
  [[nodiscard]] Eigen::Index n_forces() const;
  /// The forces that are prescribed at the balance time of the next step (n_forces).
  Eigen::VectorXd prescribed_forces();
  /// Throws GrossSlip where the friction limit of the last attempt does not bear the forces of the next step.
  void require_grip();
  /// The forces of the last attempt in these directions (n_forces).
  [[nodiscard]] Eigen::VectorXd attempted_forces() const;
  /// The largest tangential force that the limit bears.
  [[nodiscard]] double most_force() const { return (op_.areas().transpose() * limit).sum(); }

  /// Sets the displacements along the surface from which the first step starts, such as those of a body that was
  /// pressed without friction (n_rings x 2 n_angles).
  void start_from(const Eigen::MatrixXd& displacement);

  long n_steps = 0;                           ///< steps made so far
  Eigen::Vector2d displacement, increment;    ///< of the indenter at the end of the step, and in it
  Eigen::MatrixXd limit;                      ///< mu p
  Eigen::MatrixXd traction, traction_before;  ///< at the balance times of the last step and of the one before
  Eigen::MatrixXd slip;                       ///< of the points in the whole last step
  int n_iterations = 0, n_applications = 0;   ///< of the last step: Newton iterations, applications of the operator

  [[nodiscard]] const SurfaceOperator& op() const { return op_; }
  [[nodiscard]] int steps_per_cycle() const { return times_.steps_per_cycle(); }
  /// Fraction of the last step at which forces balance; before the first step, that of the first.
  [[nodiscard]] double fraction() const { return step_.fraction(); }
  [[nodiscard]] double instantaneous() const { return step_.instantaneous(); }  ///< of the same step
  /// Times and relaxation of the next step.
  struct NextStep {
    double begin, balance, end;
    const RelaxationStep& relaxation;
    [[nodiscard]] double inside() const { return (begin + end) / 2; }
  };
  NextStep next_step();
  /// Where the last step lies in its piece of a path, with its balance time as the sample; empty: the motion is made of
  /// cosines.
  [[nodiscard]] std::optional<StepInPiece> in_piece() const;
  /// Right-hand side of the last friction problem: areas times the displacements that would leave no slip along the
  /// traction (n_rings x 2 n_angles).
  [[nodiscard]] Eigen::MatrixXd pull() const;
  /// Displacements of the points along the surface at the end of the last step (n_rings x 2 n_angles).
  [[nodiscard]] Eigen::MatrixXd displacements() const;

  /// F_x, F_y and the torque about the axis that the indenter exerts at the balance time. Where a mirror leaves out
  /// angles F_y and the torque of the whole circle are 0.
  [[nodiscard]] Eigen::Vector3d forces() const;
  /// Work of friction in the step, of second order: slip is made at a constant rate, so it meets the traction in the
  /// middle of the step, between those at the balance times of this step and the one before.
  [[nodiscard]] double friction_work() const { return friction_work_of_points().sum(); }
  [[nodiscard]] Eigen::MatrixXd friction_work_of_points() const;

  /// All that the next step depends on. To be loaded into a friction that was made of the same arguments.
  template <class Archive>
  void serialize(Archive& archive) {
    archive(n_steps, displacement, increment, limit, traction, traction_before, slip, x_, y_, guess_, course_,
            balance_.displacements, balance_.stiffness, expected_way_, turning_, dt_before_);
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
  FrictionSolver solver_;
  FrictionSolution solution_;
  Eigen::MatrixXd guess_;  // for the tractions of the next attempt
  ExpectedCourse course_;  // of the tractions
  /// Moves of the indenter in the step that is attempted.
  struct Moves {
    IndenterMove x_to_balance, y_to_balance, x, y;
  };
  [[nodiscard]] Moves moves_in(const NextStep& next, const Eigen::VectorXd& along) const;
  Moves moves_{};
  BalanceOfForces balance_;      // of the next step under forces, as far as it is known
  ExpectedCourse expected_way_;  // of its displacements
  [[nodiscard]] Eigen::MatrixXd turning() const;
  Eigen::MatrixXd turning_;  // turning_slip in a step of dt_before_
  double dt_before_ = 1;     // length of the last step
  Eigen::VectorXd arms_;     // mean distances of the rings from the axis
};

}  // namespace fretval::fem
