#pragma once

#include <Eigen/Dense>

#include "fem/ring_contact/punch_series.h"

namespace fretval::fem {

/// The ring pressures p that the friction limit mu p takes: of third order in the width h of the rings on any body.
///
/// Ring pressures are a sum of punches (PunchSeries) that stands for an integral over depths D(r) up to the edge of the
/// contact. What a sum moves the surface by at a distance is right but for its end: with F(r), the force of a unit
/// punch, the midpoint rule lacks `h²/24 F' D'` at the last ring, and what lies between that ring and the edge. Both
/// together are what the force as it is read is larger by than the sum over the rings, E b² with b² = what the last
/// ring adds to F. On a half-space this does not matter: friction compares depths with depths, ring by ring. On another
/// body sums move the surface at a distance, normally and tangentially by different kernels, so that E belongs to the
/// depth of the last ring. That ring itself must not slip later for it: in the depths of friction, which sums up
/// punches of its own, E is taken off again, times the ratio of the tractions that a depth gives its own ring. With the
/// maps N and T from pressures to the depths of the normal and of the tangential problem the result is `p + N^-1 E -
/// T^-1 E'`.
///
/// pressure: of a contact that touches from the centre outwards; force: the normal force as it is read (ContactForce).
/// A ring whose pressure would not be positive keeps it.
Eigen::VectorXd pressure_for_friction(const PunchSeries& normal, const PunchSeries& tangential,
                                      const Eigen::VectorXd& pressure, double force);

}  // namespace fretval::fem
