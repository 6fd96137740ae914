#pragma once

#include <Eigen/Dense>

namespace fretval::fem {

/// How much room a point has to stick throughout a cycle in which its traction goes through (x_k, y_k) and its friction
/// limit through l_k:
///
///   max over offsets o of  min_k [l_k - |t_k - o|],
///
/// the largest by which every limit could be less while some constant traction still lets it stick. The room is
/// positive where the point sticks, and zero where it slips. The offset is the traction that shakedown would settle to,
/// so that the room does not depend on the one that a computation happens to have locked in. With one direction the
/// room is the shakedown margin of the ring contact, the mean of the least l - t and the least l + t. It is found to
/// roundoff: the largest limit minus the room is the radius of the smallest circle around circles of radii max l - l_k,
/// which three of them hold at most. One that reaches farthest beyond the circle around these is taken among them until
/// there is none (Welzl 1991; Fischer and Gärtner 2004 for circles instead of points).
double slip_room(const Eigen::VectorXd& x, const Eigen::VectorXd& y, const Eigen::VectorXd& limit);

}  // namespace fretval::fem
