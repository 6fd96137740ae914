#pragma once

#include <Eigen/Dense>

#include "fem/ring_contact/punch_series.h"

namespace fretval::fem {

/// The ring pressures p that the friction limit mu p takes: of third order in the width w of the rings on any body.
///
/// Ring pressures are a sum of punches (PunchSeries) that stands for an integral over depths D(r), taken at the radii
/// of the rings. Each depth is right, but what the sum moves at a distance has the error of the midpoint rule: with
/// F(r), the force of a unit punch, as if the depths lacked `E = -w²/24 (F' D')'/F'` inside, and at the edge of the
/// contact as much more as the force that is read lacks. On a half-space this does not matter: friction compares depths
/// with depths, ring by ring. On another body sums move the surface at a distance, normally and tangentially by
/// different kernels. Friction sums up punches of its own, which leave out E' of their depths. With the maps N and T
/// from pressures to the depths of the normal and of the tangential problem it needs `p + N^-1 E - T^-1 E'`. In the
/// last ring E' is E times the ratio of the tractions that a depth gives its own ring, as next to the edge the two
/// problems differ by that factor alone.
///
/// pressure: of a contact that touches from the centre outwards; force: the normal force as it is read (ContactForce).
/// A ring whose pressure would not be positive keeps it.
Eigen::VectorXd pressure_for_friction(const PunchSeries& normal, const PunchSeries& tangential,
                                      const Eigen::VectorXd& pressure, double force);

}  // namespace fretval::fem
