#pragma once

#include <Eigen/Dense>
#include <functional>
#include <optional>
#include <vector>

#include "fem/full_contact/contact_region.h"
#include "fem/full_contact/coupled_contact.h"
#include "fem/full_contact/vector_friction.h"
#include "fem/motion/running_minimum.h"
#include "fem/ring_contact/contact_problem.h"

namespace fretval::fem {

/// Normal and tangential problem of the ring contact of the body on the same rings, by which the edges of regions are
/// read.
struct RingProblems {
  ContactProblem normal, tangential;
};
RingProblems ring_problems(const SurfaceCompliance& surface);

/// Course of a contact with friction as a vector: where it sticks, its works, and its last cycle. Dimensionless.
struct SurfaceHistory {
  int n_cycles = 0;
  ContactRegion never_slipped;      ///< since the start
  ContactRegion sticks_in_a_cycle;  ///< throughout the last cycle
  ContactRegion sticks_at_the_end;  ///< in the last step
  ContactRegion contact;            ///< where any pressure has been in the last cycle
  std::vector<double> dissipated;   ///< by friction, in each cycle
  double tangential_work = 0;       ///< of the indenter along the surface, in the last cycle: int F_x du_x + F_y du_y
  double normal_work = 0;           ///< into the body, in the last cycle: int F_N dd; 0 but for a CoupledContact
  Eigen::Matrix3Xd forces;          ///< F_x, F_y, torque at each step of the last cycle, at the balance times
  Eigen::Matrix2Xd displacement;    ///< u_x, u_y of the indenter at the ends of the steps of the last cycle
  Eigen::VectorXd depth;            ///< into the body, at the ends of these steps; empty but for a CoupledContact
  Eigen::VectorXd normal_force;     ///< sum over the points, at the balance times of the last cycle
  std::vector<StepInPiece> pieces;  ///< of the steps of the cycle along a path; empty: the motion is made of cosines
  std::vector<Eigen::MatrixXd> pressure, traction;  ///< in the last cycle, one field for each step
  /// Largest change of a traction from the cycle before to the last one, over the largest traction.
  double periodicity = 0;
  /// Largest difference of the steps by a second algorithm (SecondAlgorithm::difference); empty: there was none.
  std::optional<double> second_difference = {};
};

/// Watches a contact step by step.
///
/// Points that have never slipped: the smallest margin mu p - |t| since the start, as depths (ContactRegion), between
/// steps as well (RunningMinimum), where |t| has always been less than its limit. Points that stick in a cycle: those
/// that touch throughout and whose room (slip_room) exceeds what is not settled yet, which is the change of their
/// traction since the cycle before plus the traction that is kept off by their slip to and fro in the cycle. Then some
/// constant traction lets them stick, and by Melan's theorem they end up with one; micro-slip on the way there, in
/// which |t| comes to its limit on one side, dies out slowly and is no sign of slip that stays. Slip to and fro is the
/// length of the path of slip less the distance between its ends; the traction that it keeps off is at most the one of
/// a ring that alone moves by that much. In the first cycle, which begins at rest and has nothing to settle to, points
/// that stick are those that have never slipped.
class SurfaceWatch {
 public:
  /// rings: must outlive this.
  SurfaceWatch(const RingProblems& rings, const AngularGrid& grid, int steps_per_cycle);
  /// To be called after each step of friction under given pressures (n_rings x n_angles).
  void see(const VectorFriction& friction, const Eigen::MatrixXd& pressure);
  /// To be called after each step of a coupled contact, in which the indenter has moved into the body by gone_down.
  void see(const CoupledContact& contact, double gone_down);
  /// The history so far; empty before the end of the first cycle.
  [[nodiscard]] SurfaceHistory report() const;
  /// SurfaceHistory::periodicity of the last cycle.
  [[nodiscard]] double periodicity() const;

 private:
  void see_step(const VectorFriction& friction, const Eigen::MatrixXd& pressure, double gone_down);
  /// Traction and friction limit of a point in the steps of the last cycle.
  struct Course {
    Eigen::VectorXd x, y, limit;
    double change;  ///< of its traction since the cycle before
  };
  [[nodiscard]] Course course_of(Eigen::Index ring, Eigen::Index angle) const;
  [[nodiscard]] Eigen::MatrixXd room() const;
  void begin_cycle();

  const RingProblems& rings_;
  AngularGrid grid_;
  int steps_per_cycle_;
  long n_steps_ = 0;
  RunningMinimum reserve_;
  Eigen::ArrayXXd ever_;               // whether points have slipped: 1 or 0
  Eigen::MatrixXd in_cycle_;           // length of slip in the cycle; infinite where points do not touch throughout
  Eigen::MatrixXd net_in_cycle_;       // slip in the cycle, x before y
  Eigen::VectorXd traction_per_slip_;  // of rings, of the relaxed body
  double instantaneous_ = 1;           // stiffness of the body in a step over that of the relaxed body
  std::vector<Eigen::MatrixXd> pressure_, traction_, limit_, traction_before_;
  Eigen::Matrix3Xd forces_;
  Eigen::Matrix2Xd displacement_;
  Eigen::VectorXd normal_force_, depth_;
  std::vector<StepInPiece> pieces_;
  Eigen::Vector3d before_{0, 0, 0};  // F_x, F_y, F_N at the last balance time
  double tangential_work_ = 0, normal_work_ = 0;
  std::vector<double> dissipated_;
};

/// How many cycles a contact is stepped through: at least those of the ramp and one more, and on until its tractions
/// repeat to `periodicity`, or most_cycles. Micro-slip dies out slowly, so that they may not repeat by then;
/// SurfaceHistory::periodicity says what is left.
struct SurfaceControl {
  int least_cycles, most_cycles;
  double periodicity = 0;
  bool has_second_algorithm = false;  ///< solve each step once more, by SecondAlgorithm
};
inline SurfaceControl exactly(int n_cycles) {
  return {n_cycles, n_cycles};
}

/// Steps friction through cycles. ring_pressure(step): the pressures of the rings at the balance time of a step,
/// counted from 0, as a NormalHistory has them.
SurfaceHistory vector_friction_history(VectorFriction friction,
                                       const std::function<Eigen::VectorXd(long)>& ring_pressure,
                                       const RingProblems& rings, const SurfaceControl& control);

/// Steps a coupled contact through cycles.
SurfaceHistory coupled_contact_history(CoupledContact contact, const RingProblems& rings,
                                       const SurfaceControl& control);

}  // namespace fretval::fem
