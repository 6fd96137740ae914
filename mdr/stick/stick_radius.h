#pragma once

#include <optional>

#include "mdr/motion/harmonic_motion.h"
#include "mdr/motion/motion.h"
#include "mdr/profiles/profile.h"
#include "mdr/rheology/rheology.h"
#include "mdr/stick/limiting_profile.h"

namespace fretval::mdr {

/// Depth g(c) of the one-dimensional profile at the edge of the stick zone, in m. Not positive: nothing sticks.
struct StickDepths {
  double first_slip;
  double shakedown;
};

/// Stick radius c in m; empty: nothing sticks, wear goes on for ever.
struct StickRadii {
  std::optional<double> first_slip;
  std::optional<double> shakedown;
};

/// Largest depths g(c) at which an element
///   first_slip: never slips, counted from rest without tangential force: the paper's criterion (19) to (27),
///   shakedown:  no longer slips once early slip has locked in the most favourable tangential force (elastic case:
///               Barber, Davies and Hills 2011). It is never less than first_slip.
///
///   T(t) = 2/(3 mu) sum_k b_k |G(w_k)|/G0 cos(w_k t + psi_k + arg G(w_k))      forces of the element, both divided
///   N(t) =          sum_j a_j |G(w_j)|/G0 cos(w_j t + phi_j + arg G(w_j))      by 4 G0 per length, T also by mu
///   M+- = sup_t(+-T - N),   first_slip = d0 - max(M+, M-),   shakedown = d0 - (M+ + M-)/2
///
///   Phase unlocked: M+- = sup_t(+-T) + sup_t(-N).
///
/// The departure from the paper: it has one stick radius, first_slip, and for two harmonics of equal frequency or of
/// unlocked phase only. Both criteria imply permanent contact, g(c) <= d0 - sup(-N).
/// Suprema as in mdr/motion/harmonic.h: where they are upper bounds, the depths are lower bounds.
/// mu positive. Throws std::invalid_argument for bad arguments.
StickDepths stick_depths(const Rheology& body, double mu, const HarmonicMotion& motion);

/// Depths g(c) in m for one harmonic in each direction, with A = 2 u_x0/(3 mu) and rho = |G|/G0:
///   equal frequencies, phase locked:      M+- = rho |A e^(i phi0) -+ Delta d|; for the paper's case list see
///                                         mdr/stick/paper_cases.h
///   phase unlocked (empty):               M+ = M- = A rho_x + Delta d rho_z, paper (21)
///   unequal frequencies, phase locked:    as above
StickDepths stick_depths(const Rheology& body, double mu, const Motion& motion);

/// Stick radius c = g^-1(depth) in m on the unworn profile; empty: nothing sticks.
std::optional<double> stick_radius(const Profile& profile, double depth);

/// The stick radii of both depths.
StickRadii stick_radii(const Profile& profile, const StickDepths& depths);

/// Stick radii in m of stick_depths(), on the unworn profile.
StickRadii stick_radii(const Profile& profile, const Rheology& body, double mu, const HarmonicMotion& motion);
StickRadii stick_radii(const Profile& profile, const Rheology& body, double mu, const Motion& motion);

/// Stick radii in m on a worn profile: its elements inside its radius c are those of the unworn one, and outside c none
/// is pressed. They are the radii of the unworn profile, but at most c: a motion smaller than the one that the profile
/// is limiting for leaves all of the contact sticking, a larger one lets its outer part slip, and wear goes on.
StickRadii stick_radii(const LimitingProfile& worn, const Rheology& body, double mu, const HarmonicMotion& motion);
StickRadii stick_radii(const LimitingProfile& worn, const Rheology& body, double mu, const Motion& motion);

}  // namespace fretval::mdr
