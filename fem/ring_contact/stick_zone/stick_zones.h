#pragma once

#include <Eigen/Dense>

#include "fem/history/friction_history.h"
#include "fem/motion/motion.h"
#include "fem/ring_contact/stick_zone/edge_radius.h"

namespace fretval::fem {

/// The stuck rings of a friction history, counted from the centre.
struct StuckRings {
  Eigen::Index first_slip;  ///< have never slipped
  Eigen::Index shakedown;   ///< no longer slip
};

/// By what they slip, and never losing their grip altogether; see slip_of_stuck_ring.
StuckRings stuck_rings(const FrictionHistory& friction, const Motion& motion);

/// Edges of both stick zones.
struct StickZones {
  EdgeRadius first_slip, shakedown;
};
StickZones stick_zones(const Compliance& tangential, const FrictionHistory& friction, const StuckRings& stuck);

}  // namespace fretval::fem
