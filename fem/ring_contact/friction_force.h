#pragma once

#include <Eigen/Dense>

#include "fem/ring_contact/punch_series.h"
#include "fem/ring_contact/slip_zones.h"

namespace fretval::fem {

/// Where rings touch, according to the normal contact.
struct TouchingRings {
  /// Per ring: radius of the contact when the ring touches, from the PunchSeries of the normal problem.
  Eigen::VectorXd radii;
  bool from_zero = true;  ///< whether the traction of a ring that touches begins at zero: not with a dashpot
  double contact_radius = 0;
  double turning_radius = 0;  ///< radius of the contact when it last began to grow

  void move_to(double radius) {
    if (radius < contact_radius || turning_radius == 0) turning_radius = radius;
    contact_radius = radius;
  }
};

/// A tangential force, and how uncertain it is because of kinks of the traction within single rings.
struct FrictionForce {
  double value, uncertainty = 0;
};

/// The tangential force. While the outermost rings slip it is what the slip reserve leaves of mu times the normal
/// force: the reserve vanishes in the slip zone, however narrow it is, so the edge of the contact plays no part. The
/// radius at which it begins to vanish is found from the reserve of the stuck rings, and from that which the next rings
/// had when their slip began, as hardly a ring of the stick zone may be left. Rings that touch again stick since the
/// edge of the contact came to them, so their depths belong to its radius then; discs of n rings are 0.0025 rings
/// larger tangentially than normally. While less than three rings have touched since the contact turned, what they
/// carry is found from the radii at which the contact turned and where it ends. limit_depths: depths of the friction
/// limit mu p; limit_force: mu times the normal force.
FrictionForce friction_force(const PunchSeries& series, const SlipZones& zones, const TouchingRings& touching,
                             const Eigen::VectorXd& limit_depths, double limit_force);

}  // namespace fretval::fem
