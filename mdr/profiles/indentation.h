#pragma once

#include "mdr/profiles/profile.h"

namespace fretval::mdr {

/// Elastic contact of an unworn indenter with an incompressible half-space of shear modulus G: the exact
/// axisymmetric solutions, read off the one-dimensional foundation with the spring loads q_z(x) = 4 G (d - g(x)) and
/// q_x = (8/3) G u_x per length. With G = G0 they are the relaxed state of a viscoelastic body.
///
/// Source: Popov and Hess, Method of Dimensionality Reduction (2015), chapters 3 and 5; paper equations (3), (5), (6),
/// (8). Arguments: shear modulus G in Pa, positive; indentation d in m, not negative; mu positive; r and u_x in m, not
/// negative. Anything else throws std::invalid_argument. Forces in N, stresses in Pa, lengths in m.

/// Contact radius a in m, with g(a) = d.
double contact_radius(const Profile& profile, double indentation);

/// Normal force F = 8 G int_0^a (d - g) dx in N. Parabola (Hertz): (16/3) G sqrt(R) d^(3/2).
double normal_force(const Profile& profile, double shear_modulus, double indentation);

/// Pressure p(r) = (4 G/pi) int_r^a g'(x)/sqrt(x^2-r^2) dx for r < a, 0 beyond; infinite where abel_slope_integral()
/// is.
double pressure(const Profile& profile, double shear_modulus, double indentation, double r);

/// Whole contact area sticks: F_x = (16/3) G a u_x.
double tangential_force_full_stick(const Profile& profile, double shear_modulus, double indentation,
                                   double tangential_displacement);

/// Tangential displacement applied monotonically after the normal load: the depth g(c) = d - 2 u_x/(3 mu) in m at the
/// edge of the stick zone, and 0 once the whole contact slides.
double stick_depth_cattaneo_mindlin(double mu, double indentation, double tangential_displacement);

/// The stick radius c in m of this tangential displacement, and 0 once the whole contact slides.
double stick_radius_cattaneo_mindlin(const Profile& profile, double mu, double indentation,
                                     double tangential_displacement);

/// The tangential force in N at this tangential displacement: F_x = mu (F(a) - F(c)), F(c) being the normal force at
/// the indentation g(c); mu F when sliding.
double tangential_force_cattaneo_mindlin(const Profile& profile, double shear_modulus, double mu, double indentation,
                                         double tangential_displacement);

}  // namespace fretval::mdr
