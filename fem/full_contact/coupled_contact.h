#pragma once

#include <Eigen/Dense>
#include <functional>
#include <optional>

#include "fem/full_contact/surface_operator.h"
#include "fem/full_contact/vector_friction.h"
#include "fem/motion/relaxation.h"
#include "fem/ring_contact/static_contact.h"

namespace fretval::fem {

/// The operators of a body on one grid: for tractions along the surface, for pressures, and what couples them.
struct CoupledOperators {
  SurfaceOperator tangential, normal;
  CouplingOperator coupling;
};

/// Throws std::invalid_argument as SurfaceOperator does, and for mirrors about both axes, which coupling breaks.
CoupledOperators coupled_operators(const SurfaceCompliance& surface, const AngularGrid& grid, bool coupling = true);

/// Motion of the indenter: its depth, and its motion along the surface.
struct IndenterMotion {
  Course depth;
  LateralMotion lateral;
  bool depth_is_force = false;  ///< depth is the force F_N, which the indenter follows at the balance time of each step
};
/// The motion of the indenter as prescribed by a Motion, which must outlive it.
IndenterMotion indenter_motion(const Motion& motion);

/// Normal contact and friction that act on each other, on their way through a motion: what they are like after the last
/// step, and how they go on. At all points
///
///   p >= 0,  gap >= 0,  p gap = 0,    |t| <= mu p,  slip along t where |t| = mu p and none elsewhere,
///
/// with displacements by both (CouplingOperator). They begin at the first depth with the pressures
/// of a relaxed body that was pressed without friction; from a depth of 0 on, frictional pressing is a part of the way.
///
/// A step alternates: friction under the last pressures, then pressures under these tractions (block Gauss-Seidel). The
/// error contracts in each alternation by the square of the coupling times the friction coefficient: over a half-space
/// ((1 - 2 nu)/(2 - 2 nu)) mu at most, and faster by AndersonMixing of the displacements by tractions. It begins with
/// the tractions and pressures that are expected by the cycle before (ExpectedCourse). The normal natural residual of
/// the pair is computed at its end, over the largest pressure, and that of friction as in FrictionSolver. Where forces
/// are prescribed the indenter moves towards their balance in each alternation, by the stiffness of earlier steps, and
/// the mixing takes its displacements along. Where the stiffness is not known yet, or that does not come to an end,
/// displacements_for_forces searches around the alternation. Points that are pressed in the step before are driven by
/// the indenter, exactly; the others move at a constant rate, so that lifting and touching are of second order (without
/// the turns inside a step of fem/ring_contact/ring_courses.h).
class CoupledContact {
 public:
  /// profile: of the indenter, n_rings x n_angles, ring means of its height over the apex. The operators and the motion
  /// must outlive this.
  CoupledContact(const CoupledOperators& operators, const RelaxationModel& relaxation, double friction_coefficient,
                 Eigen::MatrixXd profile, const IndenterMotion& motion, StepTimes times);

  /// Makes the next step, in which the indenter wears: `target = K p + coefficient p^exponent - gap` at each point,
  /// with the wear linearised around the last pressures of each alternation (Newton's method). wear: of the points,
  /// angle by angle. Throws SolverError where the alternation does not converge, NoRoom where the contact reaches the
  /// last ring, and GrossSlip where a tangential force that is prescribed reaches mu F_N.
  void step(const PressureWear& wear = {});

  Eigen::MatrixXd profile;  ///< of the indenter at the end of the step
  VectorFriction friction;
  double depth = 0;          ///< of the indenter at the end of the step
  Eigen::MatrixXd pressure;  ///< at the balance time
  Eigen::MatrixXd gap;       ///< at the end of the step
  int n_alternations = 0;    ///< alternations that the step took, the search for the balance of forces among them
  double remainder = 0;      ///< natural residual of the normal contact, over the largest pressure

  [[nodiscard]] double normal_force() const;
  [[nodiscard]] const SurfaceOperator& normal_operator() const { return operators_.normal; }
  /// Right-hand side of the last normal problem, under the tractions of the last step and without wear: areas times the
  /// displacements into the body that would leave no gap (n_rings x n_angles).
  [[nodiscard]] Eigen::MatrixXd pull() const;

  /// All that the next step depends on. To be loaded into a contact that was made of the same arguments.
  template <class Archive>
  void serialize(Archive& archive) {
    archive(profile, friction, depth, pressure, gap, expected_pressure_, course_, state_, balance_.displacements,
            balance_.stiffness, expected_way_);
  }

 private:
  void press_without_friction();
  class Together;
  /// A step that is tried: the move of the indenter, of the points how far they are driven, left behind and displaced
  /// before they are held, and areas times the displacements that would leave no gap.
  struct Attempt {
    IndenterMove whole;
    Eigen::VectorXd driven, left_behind, before;
    Eigen::MatrixXd target;
  };
  /// What a step starts from: the pressures of the step before, and the wear.
  struct Start {
    Eigen::MatrixXd pressed;
    PressureWear wear;
  };
  [[nodiscard]] Eigen::Index n_forces() const { return (motion_.depth_is_force ? 1 : 0) + friction.n_forces(); }
  [[nodiscard]] Eigen::VectorXd prescribed_forces();
  [[nodiscard]] Eigen::VectorXd attempted_forces() const;
  [[nodiscard]] Eigen::VectorXd stiffness_of_rings();
  [[nodiscard]] Attempt attempt(const Start& start, const Eigen::VectorXd& way);
  void press(const Eigen::MatrixXd& pull, const PressureWear& wear, double enough);
  double rub(const Attempt& made, const PressureWear& wear, const Eigen::VectorXd& way, double enough);
  Attempt alternate(const Start& start, const Eigen::VectorXd& way, double agreement);
  std::optional<Attempt> alternate_to_balance(const Start& start);
  Attempt balance_around(const Start& start);

  const CoupledOperators& operators_;
  InverseOperator normal_inverse_;
  RelaxationModel relaxation_;
  const IndenterMotion& motion_;
  Eigen::MatrixXd expected_pressure_;  // in the next step
  ExpectedCourse course_;              // of the pressures
  RingState state_;                    // of the displacements into the body
  BalanceOfForces balance_;            // of the next step under forces, as far as it is known
  ExpectedCourse expected_way_;        // of its displacements
  Eigen::MatrixXd softness_;           // areas times what points give way by wear, per pressure; empty without wear
  Eigen::MatrixXd moved_;              // displacements into the body by the last tractions, times the areas
  Eigen::MatrixXd opened_;             // areas times gaps at the end of the step times the instantaneous stiffness
};

}  // namespace fretval::fem
