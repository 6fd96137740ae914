#pragma once

#include <Eigen/Dense>
#include <optional>

#include "fem/punch_series.h"

namespace fretval::fem {

/// What pressures and gaps of an instant do not tell of a contact.
struct ContactPast {
  double largest_radius = 0;  ///< of the contact so far
  /// With a dashpot: rings that have been in contact for the whole step.
  std::optional<Eigen::Index> n_closed = std::nullopt;
};

/// Normal force of a contact and where it ends.
struct ContactForce {
  double force, radius;
};

/// From ring pressures and the gaps of the free rings. The edge is found from the gaps: with a dashpot, or a branch
/// that relaxes while the edge crosses a ring, the pressure jumps there. With a dashpot the pressures of the rings that
/// touched in the step are averages, so the inner ones are continued in their place.
ContactForce contact_force(const PunchSeries& series, const Eigen::VectorXd& pressure, const Eigen::VectorXd& gap,
                           const ContactPast& past = {});

}  // namespace fretval::fem
