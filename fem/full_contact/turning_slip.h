#pragma once

#include <Eigen/Dense>

namespace fretval::fem {

/// Slip that points make in a step beside the direction of their traction because that direction turns.
///
/// A point slips along its traction throughout, s = int |s'| n dt, with the unit vector n of the traction. A step holds
/// its slip along n at the balance time, the fraction phi of the step, which is of first order: where n turns by Dn
/// from one balance time to the next, that is (phi - 1/2) Dn ahead of its mean over the step. So the slip is, to second
/// order,
///
///   s = |s| n - (phi - 1/2) |s| Dn.
///
/// The second part is taken from the step before, so that each step stays a convex problem. A disturbance of the
/// direction of a point that is dragged along dies out by a factor of 2^-1/2 a step: then n = n_drag + (n_1 - n_2)/2,
/// n_1 and n_2 the directions in the two steps before. Dn counts times the cosine of the turn, which changes nothing to
/// second order, and not at all where the turn is a right angle or more, as in a reversal.
///
/// Fields have a row for each ring and two columns for each angle, x before y. along_traction: slip along the traction
/// in a step, traction and traction_before: at the balance times of this step and of the one before. Returns the second
/// part in a step of the same length; it grows with the square of that.
Eigen::MatrixXd turning_slip(const Eigen::MatrixXd& along_traction, const Eigen::MatrixXd& traction,
                             const Eigen::MatrixXd& traction_before, double fraction);

}  // namespace fretval::fem
