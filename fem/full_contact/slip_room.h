#pragma once

#include <Eigen/Dense>

namespace fretval::fem {

/// How much room a point has to stick throughout a cycle in which its traction goes through (x_k, y_k) and its friction
/// limit through l_k:
///
///   max over offsets o of  min_k [l_k - |t_k - o|],
///
/// the largest by which every limit could be less while some constant traction still lets it stick. Positive where it
/// sticks, and zero where it slips. The offset is what a body settles to by shakedown; so the room does not depend on
/// the one that it happens to have. With one direction it is the shakedown margin of the ring contact, the mean of the
/// least l - t and the least l + t. (The radius of a smallest enclosing circle, with weights.) A convex problem in two
/// unknowns, solved to 1e-8 of the range of the tractions.
double slip_room(const Eigen::VectorXd& x, const Eigen::VectorXd& y, const Eigen::VectorXd& limit);

}  // namespace fretval::fem
