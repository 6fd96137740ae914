#pragma once

#include <Eigen/Dense>

#include "fem/motion/relaxation.h"
#include "fem/ring_contact/punch_series.h"

namespace fretval::fem {

/// What a step of the normal history has beyond rings that move at a constant rate: how far the indenter drives them,
/// whose motion is known exactly, and what the body has of a way that turns inside the step.
struct RingCourses {
  Eigen::VectorXd driven;  ///< per displacement of the indenter
  bool has_turns = false;
  Eigen::VectorXd response = {};  ///< to the turns, at the balance time
  Eigen::MatrixXd memory = {};    ///< of the turns at the end of the step, n_rings x n_branches
  /// Of the depth of a ring that touches in the step: how much more it bears at the balance time than what belongs to
  /// the whole step. Minus infinity: it touches after that.
  Eigen::VectorXd passing_depths = {};

  /// What the indenter moves by and rings do not follow. increment: of the indenter in the step.
  [[nodiscard]] auto left_behind(double increment) const { return ((1 - driven.array()) * increment).matrix(); }
  /// From depths of pressures, in whose place they are: those of the instant.
  void to_instant(Eigen::VectorXd& depths) const { depths = (depths + passing_depths).cwiseMax(0); }
};

/// At the start of a step, as depths or displacements of PunchSeries. standing: what rings would bear at the balance
/// time if they and the indenter stood still.
struct RingsAtStart {
  Eigen::VectorXd load, standing, gap;
};

/// How rings spend a step in which they lift or touch. In the depths of the punch series each is on its own, like a
/// spring of MDR. One that is in contact and would bear less than nothing if it followed the indenter all the time
/// lifts before, when its load, linear in time, vanishes. A free one that would be inside the indenter at the end if it
/// went on by itself touches before, when its gap vanishes. Until it lifts, or from when it touches, a ring goes with
/// the indenter, and else by itself: two straight lines in time, with a turn between them. It is driven for the share
/// of the step in which it is in contact, so that nothing jumps when it lifts or touches.
///
/// Without the turns forces are of second order too, but in a stiff branch that lifts off forty times as far off: its
/// memory of what came late in the step has had less time to fade. A parallel dashpot has no memory, and what it bears
/// belongs to the whole step (RelaxationStep), but for what is read of an instant (passing_depths).
///
/// to_balance: of the indenter up to the balance time; increment: of the whole step. courses: what comes out, in the
/// room that they have.
void find_courses(const PunchSeries& series, const RelaxationStep& step, const RingsAtStart& rings,
                  const IndenterMove& to_balance, double increment, RingCourses& courses);

}  // namespace fretval::fem
