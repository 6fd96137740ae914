#pragma once

#include "mdr/profiles/profile.h"

namespace fretval::mdr {

/// The worn profile that wears no more: unworn where the contact sticks, r < c, and out of reach of the pressure
/// beyond.
///
///   f_inf(r) = f0(r)                                                                     r <= c or r >= a_inf
///            = (2/pi) int_0^c g0(x)/sqrt(r^2-x^2) dx + (2/pi) d_max arccos(c/r)          c < r < a_inf
///
/// Source: paper, equations (9), (12) and (13). The paper leaves the outer radius open; here a_inf is where f_inf meets
/// the unworn profile again, f_inf(a_inf) = f0(a_inf): beyond it the free surface of the loaded body stays below f0.
/// Lengths in m. Made by limiting_profile().
struct LimitingProfile {
  Profile unworn;
  double stick_radius;         ///< c
  double maximum_indentation;  ///< d_max
  double outer_radius;         ///< a_inf, not less than the unworn contact radius a0 = g^-1(d_max)
};

/// Requires d_max > 0 and 0 < c <= a0; c = a0 wears nothing and gives a_inf = a0. Throws std::invalid_argument.
LimitingProfile limiting_profile(const Profile& unworn, double stick_radius, double maximum_indentation);

/// f_inf(r) in m at r >= 0.
double shape(const LimitingProfile& profile, double r);

/// Depth of wear f_inf(r) - f0(r) >= 0 in m, with the relative accuracy of its own small size as r -> c.
double worn_depth(const LimitingProfile& profile, double r);

/// Volume in m^3 that is worn off: `2 pi int_c^a_inf worn_depth(r) r dr`, relative accuracy 1e-10.
double worn_volume(const LimitingProfile& profile);

/// g_inf(x) in m, paper equation (9): g0 for |x| <= c, d_max beyond. Holds up to the contact radius at d_max.
double transform(const LimitingProfile& profile, double x);

/// Normal force in N on the limiting profile at an indentation 0 <= d <= d_max in m, body of shear modulus G in Pa:
///   F = 8 G int_0^c max(d - g0, 0) dx,   for g0(c) <= d: 8 G (c d - int_0^c g0 dx)
double limiting_normal_force(const LimitingProfile& profile, double shear_modulus, double indentation);

}  // namespace fretval::mdr
