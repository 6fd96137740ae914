#pragma once

#include <Eigen/Dense>

#include "fem/motion/relaxation.h"
#include "fem/ring_contact/punch_series.h"

namespace fretval::fem {

/// How rings move in a step of the normal history, beyond a constant rate: how far they are driven by the indenter,
/// whose motion is known exactly, and what the turn of a ring that lifts or touches within the step adds.
struct RingCourses {
  Eigen::VectorXd driven;           ///< displacement of each ring per displacement of the indenter
  Eigen::VectorXd touches_at = {};  ///< share of the step after which a ring touches; 0 for all others
  bool has_turns = false;
  Eigen::VectorXd response = {};  ///< of the body to the turns, at the balance time
  Eigen::MatrixXd memory = {};    ///< of the turns at the end of the step, n_rings x n_branches
  /// For a ring that touches in the step, by how much the load of its depth at the balance time exceeds that which
  /// belongs to the whole step. Minus infinity: it touches after the balance time.
  Eigen::VectorXd passing_depths = {};

  /// Part of the increment of the indenter in a step that the rings do not follow, per ring.
  [[nodiscard]] auto left_behind(double increment) const { return ((1 - driven.array()) * increment).matrix(); }
  /// Turns depths of pressures of the whole step into those at the balance time.
  void to_instant(Eigen::VectorXd& depths) const { depths = (depths + passing_depths).cwiseMax(0); }
};

/// Loads and gaps of the rings at the start of a step, as depths and displacements of PunchSeries. standing: the loads
/// at the balance time if rings and indenter stood still.
struct RingsAtStart {
  Eigen::VectorXd load, standing, gap;
};

/// How rings spend a step in which they lift or touch. In the depths of the punch series each is on its own, like a
/// spring of MDR. A ring in contact that would be pulled at the end of the step if it followed the indenter all the
/// time lifts before, when its load, linear in time, vanishes. A free ring that would be inside the indenter at the end
/// of the step if it went on by itself touches before, when its gap vanishes. Until it lifts, or from when it touches,
/// a ring moves with the indenter, and otherwise by itself: along two straight lines in time, with a turn between them.
/// It is driven for the share of the step in which it is in contact, so that nothing jumps when it lifts or touches.
///
/// Without the turns forces are of second order, too, but in a body with a stiff branch that lifts off forty times less
/// accurate: the memory of what came late in the step has had less time to fade. A parallel dashpot has no memory, and
/// what it bears belongs to the whole step (RelaxationStep), except in what is read at an instant (passing_depths).
///
/// to_balance: move of the indenter up to the balance time; increment: that of the whole step. courses: the result,
/// written into the memory that it has.
void find_courses(const PunchSeries& series, const RelaxationStep& step, const RingsAtStart& rings,
                  const IndenterMove& to_balance, double increment, RingCourses& courses);

}  // namespace fretval::fem
