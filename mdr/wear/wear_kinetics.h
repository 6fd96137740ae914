#pragma once

#include <Eigen/Core>
#include <vector>

#include "mdr/motion/motion.h"
#include "mdr/profiles/profile.h"
#include "mdr/rheology/prony_body.h"

namespace fretval::mdr {

/// What to wear, and how finely.
struct WearControl {
  double wear_coefficient;       ///< k in 1/Pa: worn depth per pressure and path of slip (Archard's K over hardness)
  double n_cycles;               ///< number of cycles to compute; jumps take many of them at once
  Eigen::Index n_springs = 150;  ///< to start from; the stick radius becomes an edge of their intervals
  int steps_per_cycle = 90;
  double largest_jump = 0.005;         ///< in worn depth, over d_max
  std::vector<double> snapshots = {};  ///< numbers of cycles, rising, at which to keep the worn depth
};

/// One point of the kinetic curves.
struct WearPoint {
  double cycles;
  double volume;          ///< worn off, m^3
  double deepest;         ///< largest worn depth, m
  double friction_work;   ///< J per cycle
  double contact_radius;  ///< largest in the cycle, m; worn surfaces that only just part count as touching
  double stick_radius;    ///< m; springs inside do not slip in the cycle; 0: all slip
};

/// Course of the wear, and the profile at its end.
struct WearKinetics {
  std::vector<WearPoint> curve;           ///< from 0 to n_cycles; in the long run evenly spaced in log cycles
  Eigen::ArrayXd radius;                  ///< of the middles of the rings, m
  Eigen::ArrayXd worn_depth;              ///< mean over each ring, m
  std::vector<Eigen::ArrayXd> snapshots;  ///< worn depth at the cycles asked for
};

/// Fretting wear by the law of Reye, Archard and Khrushchov through the transient spring foundation: in each cycle
///
///   dw(r) = k int p(r,t) |ds(r,t)|
///
/// with pressure and slip transformed from the springs to the surface, and g = g0 + T w transformed back. In Reye's
/// form, worn volume is k/mu times friction work. Only k times the number of cycles matters.
///
/// Exact on the springs' bed: triangularity and energy of the transforms (mdr/wear/abel_matrices.h), so that errors of
/// repeated transforms do not grow; no wear inside the stick radius; a state without pressure under slip stays as it
/// is. The transforms are applied to w itself each time, never to their own result.
///
/// Approximate, with the order of the error:
///   n_springs        rings of constant height, next to the stick radius, where w rises like a root: volume and mean
///                    worn depth with the power 3/2 of the spacing, largest worn depth with 1/2. A history of the
///                    springs on the unworn profile finds the stick radius first, and the bed is laid with an edge
///                    on it; it does not move, as wear leaves the springs inside alone. A stick radius below half
///                    a spacing is taken for 0.
///   largest_jump     second order, in the course only; less where rings begin to wear inside a jump. A jump is made
///                    at once and in two halves, implicit in the pressure and explicit in the slip, so that any number
///                    of cycles is stable and none wears beyond the loss of pressure.
///   steps_per_cycle  second order. The sampled tractions miss their extremes by (pi/steps)^2/2, and the stick depth
///                    g(c) by that share of d_0 - g(c): little but for small stick radii.
///   One-dimensional friction and pressure of the sign of the springs', as the method of dimensionality reduction has
///   them.
///
/// With a growing number of cycles w tends to the worn depth of limiting_profile() with the shakedown radius; where
/// nothing sticks, to d_max - f0: under a given motion wear always ends. At phase 0 or pi and 2 u_x0 <= 3 mu Delta d
/// everything that touches an elastic body sticks, and nothing wears. Friction work per cycle may rise first, as the
/// slip zone wears in, before it dies out.
///
/// Cost: 100 to 600 jumps, each of four cycles of the springs, more in a body that relaxes slowly, and some solutions
/// with a dense matrix of the slipping rings. Source: Dimaki, Dmitriev, Chai and Popov, International Journal of Solids
/// and Structures 51 (2014) 4215, extended to normal oscillation, viscoelastic springs and implicit jumps. Throws
/// std::invalid_argument for bad arguments and when a profile table ends too early; std::runtime_error when the springs
/// do not become periodic, as a relaxation time is far longer than the period.
WearKinetics wear_kinetics(const Profile& profile, const PronyBody& body, double mu, const Motion& motion,
                           const WearControl& control);

}  // namespace fretval::mdr
