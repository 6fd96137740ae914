#pragma once

#include <Eigen/Dense>

#include "fem/ring_contact/contact_events.h"
#include "fem/ring_contact/stick_zone/edge_radius.h"

namespace fretval::fem {

/// Largest contact radius of a cycle from the smallest gap of each ring (see NormalHistory): the remaining gap of the
/// first ring that never touches says how much deeper the indenter would have had to go for the next event. While the
/// contact is the largest so far, the surface moves as in the elastic contact whatever the rheology (Lee & Radok), so
/// the elastic events apply. Between events the radius is read from the polynomial through the six nearest.
EdgeRadius largest_contact_radius(const Eigen::VectorXd& smallest_gap, const ContactEvents& events);

}  // namespace fretval::fem
