#pragma once

#include <functional>
#include <optional>

#include "mdr/motion/harmonic_motion.h"
#include "mdr/profiles/profile.h"
#include "mdr/rheology/rheology.h"
#include "mdr/stick/limiting_state.h"

namespace fretval::mdr {

/// The fully worn contact that wear leads to, and how the indenter moves on it: displacements, the largest indentation
/// at time 0.
struct LimitingMotion {
  double stick_radius;  ///< c in m
  HarmonicMotion motion;
};

/// limiting_state() for any harmonics in either direction. The contact radius is c at all times, so that the contact is
/// linear and every harmonic acts by itself: a force F_j cos(w_j t + phi_j) has the displacement F_j/(8 |G(w_j)| c)
/// cos(w_j t + phi_j - arg G(w_j)), or 16/3 for 8 in the tangential direction, and
///
///   d0 = g(c) + (F0/(8 G0) - (c g(c) - int_0^c g dx))/c under a normal force,   g(c) = stick_depths().
///
/// prescribed: in m or, with a force in its place, in N. Empty: no contact radius carries the oscillation without slip.
/// Throws std::invalid_argument for bad arguments, std::runtime_error for a tangential force within roundoff of the
/// largest that sticks.
std::optional<LimitingMotion> limiting_motion(const Profile& profile, const Rheology& body, double mu,
                                              const HarmonicMotion& prescribed, bool with_normal_force,
                                              bool with_tangential_force, StickCriterion criterion);

/// The same for any depth g(c) at the edge of the stick zone, as a function of the displacements of the indenter: with
/// plane_stick_depths() of mdr/plane/plane_stick.h for a motion in two directions.
std::optional<LimitingMotion> limiting_motion(const Profile& profile, const Rheology& body,
                                              const HarmonicMotion& prescribed, bool with_normal_force,
                                              bool with_tangential_force,
                                              const std::function<double(const HarmonicMotion&)>& sticking_depth_of);

}  // namespace fretval::mdr
