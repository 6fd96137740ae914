#pragma once

#include <Eigen/Dense>

#include "fem/history/friction_history.h"
#include "fem/motion/motion.h"
#include "fem/ring_contact/stick_zone/edge_radius.h"

namespace fretval::fem {

/// The stuck rings of a friction history, counted from the centre.
struct StuckRings {
  Eigen::Index first_slip;  ///< number of rings that have never slipped
  Eigen::Index shakedown;   ///< number of rings that no longer slip
};

/// Counts rings from the centre whose friction margin is always positive and that slip by no more than roundoff from
/// the start on (first slip), or by no more than slip_of_stuck_ring() in the last period (shakedown).
StuckRings stuck_rings(const FrictionHistory& friction, const Motion& motion);

/// Edges of the stick zones of first slip and of shakedown.
struct StickZones {
  EdgeRadius first_slip, shakedown;
};
StickZones stick_zones(const Compliance& tangential, const FrictionHistory& friction, const StuckRings& stuck);

}  // namespace fretval::fem
