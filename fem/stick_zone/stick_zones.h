#pragma once

#include <Eigen/Dense>

#include "fem/history/friction_history.h"
#include "fem/history/normal_history.h"
#include "fem/motion/motion.h"
#include "fem/stick_zone/edge_radius.h"

namespace fretval::fem {

/// The stuck rings of a friction history, counted from the centre.
struct StuckRings {
  Eigen::Index first_slip;  ///< have never slipped
  Eigen::Index shakedown;   ///< no longer slip
};

/// By what they slip, and never losing their grip altogether; see slip_of_stuck_ring.
StuckRings stuck_rings(const FrictionHistory& friction, const Motion& motion);

/// Edges of both stick zones. They scatter by 3e-4 rings with the mesh (4.5e-4 measured, with a bar of half of that
/// from other sources). One that ends with the smallest contact, or less than two rings inside, is uncertain by a
/// thousandth of a ring: the reserve does not go on smoothly there (7e-4 rings off at most where both end
/// together, 8e-4 a ring inside, at 32 to 192 rings). Under a blunt indenter, f ~ r^exponent around the edge, it falls
/// steeply, and 12.5 (exponent - 2) h^2 rings come on top, h the ring over the radius: under r^6 edges are off by 0.04
/// rings at 32 rings, 0.005 at 64, 0.003 at 128, in all readings alike.
struct StickZones {
  EdgeRadius first_slip, shakedown;
};
StickZones stick_zones(const Compliance& tangential, const NormalHistory& normal, const FrictionHistory& friction,
                       const StuckRings& stuck, double exponent = 2);

}  // namespace fretval::fem
