#pragma once

#include <Eigen/Dense>

#include "fem/ring_contact/punch_series.h"

namespace fretval::fem {

/// By how much the tangential force is off in each step of a period because sliding ends within steps: the force that
/// was computed less that of small steps. Dimensionless.
///
/// A punch of the PunchSeries that slides has no room, R = mu p - |t| = 0, until the rate rises through 0 at which
/// sticking would make room. The step around that instant slides or sticks as a whole, whichever is nearer. What it
/// locks in is off by R'' (x dt)^2/2, |x| <= 1/2 steps from its end, until the punch slides again or lifts: the depth
/// below 0 of the vertex of the parabola through R at the last step that slides and at the two after it. So is what
/// a punch locks in that slides between two samples alone. Where sliding ends the steps have an error of second order
/// with a factor that depends on how they lie, so that the errors of two numbers of steps do not tell each other. Of a
/// body with memory what is locked in fades, and this is its largest value.
///
/// depths, limit_depths: of the traction and of mu p, a column a step. repeats: whether the first step follows the last
/// one.
Eigen::VectorXd force_off_by_sliding_ends(const PunchSeries& series, const Eigen::MatrixXd& depths,
                                          const Eigen::MatrixXd& limit_depths, bool repeats);

}  // namespace fretval::fem
