#pragma once

#include <Eigen/Dense>

#include "fem/edge.h"
#include "fem/friction_history.h"
#include "fem/motion.h"
#include "fem/normal_history.h"

namespace fretval {

/// The stuck rings of a friction history, counted from the centre.
struct StuckRings {
  Eigen::Index first_slip;  ///< have never slipped
  Eigen::Index shakedown;   ///< no longer slip
};

/// THEORY section 3: a ring that has shaken down still creeps a little while the offset settles.
StuckRings stuck_rings(const fem::FrictionHistory& friction, const fem::Motion& motion);

/// Edges of both stick zones. One that ends with the smallest contact, or less than two rings inside, is uncertain by a
/// thousandth of a ring more: the reserve does not go on smoothly there (7e-4 rings off at most where both end
/// together, 8e-4 a ring inside, at 32 to 192 rings).
struct StickZones {
  fem::EdgeRadius first_slip, shakedown;
};
StickZones stick_zones(const fem::Compliance& tangential, const fem::NormalHistory& normal,
                       const fem::FrictionHistory& friction, const StuckRings& stuck);

}  // namespace fretval
