#pragma once

#include "mdr/layer/layer_contact.h"

namespace fretval::mdr {

/// The worn profile that wears no more, on a layer: unworn where the contact sticks, r < c, and along the free surface
/// of the layer at the largest indentation beyond,
///
///   g_inf(x) = g(x)                                              x < c
///            = d_max - w(x),  E* w = (1/pi) int_-c^c K q dy      x > c
///   f_inf(r) = (2/pi) int_0^r g_inf(x)/sqrt(r^2-x^2) dx          c < r < a_inf,   f otherwise
///
/// q bears d_max - g within c: the unworn contact of radius c, which ends at its depth D(c) (layer_contact), and a flat
/// punch of radius c for the rest, d_max - D(c). Over a half-space w = 0, which is the paper's (13). a_inf is where
/// f_inf meets f again. As the contact keeps its radius, displacements are those of an elastic layer in every body.
/// Lengths in m. Accuracy 1e-10.
struct LayerLimitingProfile {
  Profile unworn;
  Layer layer;
  double stick_radius;         ///< c
  double maximum_indentation;  ///< d_max
  double unworn_depth;         ///< D(c)
  double outer_radius;         ///< a_inf
  LayerKernel kernel;          ///< normal, reaching as far as a_inf
  Eigen::ArrayXd amplitudes;   ///< of q/E* at d_max
};

/// Requires d_max > 0 and 0 < c <= a, the contact radius at d_max. Throws std::invalid_argument.
LayerLimitingProfile layer_limiting_profile(const Profile& unworn, const Layer& layer, double stick_radius,
                                            double maximum_indentation);

/// f_inf(r), f_inf(r) - f(r) and g_inf(x), in m; r and x up to 1.5 a_inf.
double shape(const LayerLimitingProfile& profile, double r);
double worn_depth(const LayerLimitingProfile& profile, double r);
double transform(const LayerLimitingProfile& profile, double x);

/// Volume in m^3 that is worn off: `2 pi int_c^a_inf worn_depth(r) r dr`, relative accuracy 1e-9.
double worn_volume(const LayerLimitingProfile& profile);

/// Normal force in N at an indentation D(c) <= d <= d_max: that of the unworn contact of radius c, and of the punch.
double limiting_normal_force(const LayerLimitingProfile& profile, double shear_modulus, double indentation);

/// Pressure p(r) in Pa at such an indentation, singular at r = c.
double limiting_pressure(const LayerLimitingProfile& profile, double shear_modulus, double indentation, double r);

}  // namespace fretval::mdr
