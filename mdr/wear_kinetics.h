#pragma once

#include <Eigen/Core>
#include <vector>

#include "mdr/motion.h"
#include "mdr/profile.h"
#include "mdr/prony_body.h"

namespace fretval::mdr {

/// What to wear, and how finely.
struct WearControl {
  double wear_coefficient;  ///< k in 1/Pa: worn depth per pressure and path of slip (Archard's K over hardness)
  double n_cycles;          ///< to compute; jumps over many of them are taken at once
  Eigen::Index n_springs = 150;
  int steps_per_cycle = 90;
  double largest_jump = 0.02;  ///< in worn depth, over d_max
};

/// One point of the kinetic curves.
struct WearPoint {
  double cycles;
  double volume;          ///< worn off, m^3
  double deepest;         ///< worn depth, m
  double friction_work;   ///< J per cycle
  double contact_radius;  ///< largest, m
  double stick_radius;    ///< m
};

/// Course of the wear, and the profile at its end.
struct WearKinetics {
  std::vector<WearPoint> curve;
  Eigen::ArrayXd radius;      ///< of the middles of the rings, m
  Eigen::ArrayXd worn_depth;  ///< m
};

/// Fretting wear by the law of Reye, Archard and Khrushchov through the transient spring foundation: in each cycle
///
///   dw(r) = k int p(r,t) |ds(r,t)|
///
/// with pressure and slip transformed from the springs to the surface, and g = g0 + T w transformed back. In the first
/// equation Reye's form, volume per friction work, is the same with k/mu. The transforms are applied to w itself each
/// time, never to their own result, so that errors do not pile up. Jumps over many cycles are implicit in the pressure
/// that the wear relieves: stable for any size; their error is of the order of largest_jump. Two cycles of the springs
/// are computed for each jump, the first to let them settle.
///
/// As k times the number of cycles grows, w tends to limiting_profile() of the shakedown radius. Wear that goes on for
/// ever, where nothing sticks, is followed until the contact meets the end of the springs, which lie on 1.15 times the
/// largest radius that a limiting profile can have.
/// Source: Dimaki, Dmitriev, Chai and Popov, International Journal of Solids and Structures 51 (2014) 4215, extended to
/// normal oscillation and viscoelastic springs.
/// Throws std::invalid_argument for bad arguments and when a profile table ends too early.
WearKinetics wear_kinetics(const Profile& profile, const PronyBody& body, double mu, const Motion& motion,
                           const WearControl& control);

}  // namespace fretval::mdr
