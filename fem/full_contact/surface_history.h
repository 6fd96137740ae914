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

/// The ring contacts of the body on the same rings, of which the edges of regions are read.
struct RingProblems {
  ContactProblem normal, tangential;
};
RingProblems ring_problems(const SurfaceCompliance& surface);

/// What a contact with friction as a vector has been through, and its last cycle.
struct SurfaceHistory {
  int n_cycles = 0;
  ContactRegion never_slipped;      ///< since the start
  ContactRegion sticks_in_a_cycle;  ///< throughout the last cycle
  ContactRegion sticks_at_the_end;  ///< in the last step
  ContactRegion contact;            ///< where any pressure has been in the last cycle
  std::vector<double> dissipated;   ///< by friction, in each cycle
  double tangential_work = 0;       ///< of the indenter along the surface, in the last cycle: int F_x du_x + F_y du_y
  double normal_work = 0;           ///< and into it, int F_N dd; where nobody has told how deep it goes, 0
  Eigen::Matrix3Xd forces;          ///< F_x, F_y, torque at each step of the last cycle, at the balance times
  Eigen::Matrix2Xd displacement;    ///< of the indenter along the surface, at the ends of the steps
  Eigen::VectorXd depth;            ///< and into the body; empty where nobody has told
  Eigen::VectorXd normal_force;     ///< the sum over the points, at the balance times
  std::vector<StepInPiece> pieces;  ///< of a path, per step of the cycle; empty: of cosines
  std::vector<Eigen::MatrixXd> pressure, traction;  ///< of the last cycle, a step each
  /// Largest change of a traction against the cycle before, over the largest one.
  double periodicity = 0;
  /// By how much the steps differ by a second algorithm (SecondAlgorithm); empty: there was none.
  std::optional<double> second_difference = {};
};

/// Watches a contact step by step.
///
/// Points that have never slipped: the smallest margin mu p - |t| since the start, as depths (ContactRegion), between
/// steps as well (RunningMinimum), where |t| has always been less than its limit. Points that stick in a cycle: those
/// that touch throughout and whose room (slip_room) exceeds all that is not settled about it, which is the change of
/// their traction since the cycle before, and the traction that their slip to and fro in the cycle keeps off. Then
/// some constant traction lets them stick, and by Melan's theorem they end up with one; micro-slip on the way there,
/// in which |t| comes to its limit on one side, dies out slowly and is no sign of slip that stays. Slip to and fro is
/// the length of the way less how far it leads; the traction that it keeps off is at most that of a ring that alone
/// moves so far. In the first cycle, which begins at rest and has nothing to settle to, points that stick are those
/// that have never slipped.
class SurfaceWatch {
 public:
  /// rings: must outlive this.
  SurfaceWatch(const RingProblems& rings, const AngularGrid& grid, int steps_per_cycle);
  /// After a step of friction under given pressures.
  void see(const VectorFriction& friction, const Eigen::MatrixXd& pressure);
  /// The same of a coupled contact, in which the indenter has gone down by so much.
  void see(const CoupledContact& contact, double gone_down);
  /// Empty before the end of the first cycle.
  [[nodiscard]] SurfaceHistory report() const;
  /// Of the last cycle against the one before, see SurfaceHistory.
  [[nodiscard]] double periodicity() const;

 private:
  void see_step(const VectorFriction& friction, const Eigen::MatrixXd& pressure, double gone_down);
  /// Of a point through the last cycle.
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
  double instantaneous_ = 1;           // by how much the body is stiffer in a step
  std::vector<Eigen::MatrixXd> pressure_, traction_, limit_, traction_before_;
  Eigen::Matrix3Xd forces_;
  Eigen::Matrix2Xd displacement_;
  Eigen::VectorXd normal_force_, depth_;
  std::vector<StepInPiece> pieces_;
  Eigen::Vector3d before_{0, 0, 0};  // F_x, F_y, F_N at the last balance time
  double tangential_work_ = 0, normal_work_ = 0;
  std::vector<double> dissipated_;
};

/// How many cycles a contact is stepped through: those of a ramp and one more at least, until it repeats, or so many.
/// Micro-slip dies out slowly, so that it may not; what is left then the history says.
struct SurfaceControl {
  int least_cycles, most_cycles;
  double periodicity = 0;
  bool has_second_algorithm = false;  ///< solve each step once more
};
inline SurfaceControl exactly(int n_cycles) {
  return {n_cycles, n_cycles};
}

/// Steps friction through cycles under pressures of the rings that act in each step, counted from 0: those at its
/// balance time, as of a NormalHistory.
SurfaceHistory vector_friction_history(VectorFriction friction,
                                       const std::function<Eigen::VectorXd(long)>& ring_pressure,
                                       const RingProblems& rings, const SurfaceControl& control);

/// Steps a coupled contact through cycles.
SurfaceHistory coupled_contact_history(CoupledContact contact, const RingProblems& rings,
                                       const SurfaceControl& control);

}  // namespace fretval::fem
