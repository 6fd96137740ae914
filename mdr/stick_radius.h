#pragma once

#include <optional>

#include "mdr/motion.h"
#include "mdr/profile.h"
#include "mdr/rheology.h"

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
///   A = 2 u_x0/(3 mu),   M+- = max_t(+-T - N),   T = A rho cos(Omega + phi0),   N = Delta d rho cos(Omega)
///   first_slip = d0 - max(M+, M-),   shakedown = d0 - (M+ + M-)/2
///
///   Equal frequencies, phase locked: M+- = rho |A e^(i phi0) -+ Delta d|.
///   Phase unlocked (empty), whatever the frequencies: M+ = M- = A rho_x + Delta d rho_z, paper (21) with rho = |G|/G0
///   taken at each motion's own frequency.
///
/// The departure from the paper: it has one stick radius, first_slip, as a list of cases; for its case list see
/// mdr/paper_cases.h. Both criteria imply permanent contact, g(c) <= d0 - rho Delta d.
/// mu positive. Throws std::invalid_argument for bad arguments and for a locked phase between unequal frequencies,
/// which is not covered.
StickDepths stick_depths(const Rheology& body, double mu, const Motion& motion);

/// The stick radii c = g^-1 of the depths above, for the unworn profile.
StickRadii stick_radii(const Profile& profile, const Rheology& body, double mu, const Motion& motion);

}  // namespace fretval::mdr
