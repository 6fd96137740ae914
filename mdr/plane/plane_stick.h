#pragma once

#include <Eigen/Core>
#include <optional>

#include "mdr/motion/harmonic_motion.h"
#include "mdr/motion/sampled_path.h"
#include "mdr/rheology/prony_body.h"
#include "mdr/rheology/rheology.h"
#include "mdr/stick/path_depths.h"

namespace fretval::mdr {

/// Forces of an element of depth 0 that stays in contact and sticks, at instants of a period or pass: the normal one
/// N(t) over 4 G0 per length, and the tangential one (X, Y)(t) over 4 mu G0, of the departure from rest; m.
struct StuckElement {
  Eigen::ArrayXd x, y, normal;
};

/// The element under a motion with a common cycle and a locked phase, at n_instants of a cycle. Throws
/// std::invalid_argument for other motions.
StuckElement stuck_element(const Rheology& body, double mu, const HarmonicMotion& motion, int n_instants);

/// The element along a path, at the first row of each piece and at the ends of n_per_piece equal steps of it.
StuckElement stuck_element(const PronyBody& body, double mu, const SampledPath& path, int n_per_piece);

/// Depths g(c) at the edge of the stick zone where the indenter moves in two directions along the surface and friction
/// is a vector, |q| <= mu q_z:
///
///   first_slip = min_t [N - |T|],    shakedown = max over offsets o of min_t [N - |T - o|],    T = (X, Y),
///
/// as for one direction (mdr/stick/stick_radius.h), in which |T| takes the place of +-T: an element at depth g bears
/// N - g. The offset is the tangential force that is locked in, a vector. Under a circle of radius u with an elastic
/// body, both are `d0 - 2 u/(3 mu)`. Between the instants N - |T| is missed by the second order of their distance.
StickDepths plane_stick_depths(const StuckElement& element);

/// The same of a motion by harmonics, at so many instants of its fastest oscillation. Throws as stuck_element().
constexpr int instants_per_oscillation = 4096;
StickDepths plane_stick_depths(const Rheology& body, double mu, const HarmonicMotion& motion);

}  // namespace fretval::mdr
