#pragma once

#include "mdr/motion/motion.h"
#include "mdr/profiles/profile.h"
#include "mdr/rheology/rheology.h"
#include "mdr/stick/limiting_profile.h"

namespace fretval::mdr {

/// Contact stress at a radius r with the part that is singular at the edge c of a worn contact kept separate:
///   stress = regular + intensity/sqrt(c^2 - r^2) for r < c,   0 beyond
struct EdgeStress {
  double regular;      ///< Pa
  double intensity;    ///< Pa m; 0 in an unworn contact
  double edge_radius;  ///< c in m
};

/// The sum of both parts in Pa; infinite at r = c if the intensity is not 0.
double total(const EdgeStress& stress, double r);

/// Fields on the surface of a body of shear modulus G under an unworn indenter at indentation d. With the fields of
/// MDR, u(r) = (2/pi) int_0^r u_1D(x)/sqrt(r^2-x^2) dx. Source: Popov and Hess (2015), chapters 3 and 5.
/// SI units; r in m, not negative. All functions of this header throw std::invalid_argument for bad arguments.

/// u_z in m, positive into the body: d - f(r) in contact, (2/pi) int_0^a (d - g)/sqrt(r^2-x^2) dx outside.
double normal_displacement(const Profile& profile, double indentation, double r);

/// u_x in m after a tangential displacement u_x of the indenter at constant d, Cattaneo and Mindlin:
/// (3 mu/2) [u_z(r; d) - u_z(r; g(c))]; u_x itself in the stick zone.
double tangential_displacement_cattaneo_mindlin(const Profile& profile, double mu, double indentation,
                                                double tangential_displacement, double r);

/// tau = mu [p(r; d) - p(r; g(c))] in Pa of the same state; mu p in the slip zone.
double traction_cattaneo_mindlin(const Profile& profile, double shear_modulus, double mu, double indentation,
                                 double tangential_displacement, double r);

/// The pressure under an indenter in its limiting state. With the whole stick zone in contact, g0(c) < d,
///   p = (4 G/pi) [int_r^c g0'(x)/sqrt(x^2-r^2) dx + (d - g0(c))/sqrt(c^2-r^2)],
/// at less indentation the pressure is the unworn one and has no singular part.
EdgeStress limiting_pressure(const LimitingProfile& profile, double shear_modulus, double indentation, double r);

/// u_z in m under the limiting profile.
double limiting_normal_displacement(const LimitingProfile& profile, double indentation, double r);

/// Full stick inside c: tau = (8 G/(3 pi)) u_x/sqrt(c^2-r^2), all of it singular.
EdgeStress limiting_traction(const LimitingProfile& profile, double shear_modulus, double tangential_displacement,
                             double r);

/// u_x in m: the indenter's inside c, (2/pi) u_x arcsin(c/r) outside.
double limiting_tangential_displacement(const LimitingProfile& profile, double tangential_displacement, double r);

/// Pressure and traction of the limiting state in the course of an oscillation, at the time t in s:
///   p:   regular (4 G0/pi) int_r^c g0'/sqrt(x^2-r^2) dx,
///        intensity (4/pi) [G0 (d0 - g0(c)) + Delta d Re(G(omega) e^(i omega t))]
///   tau: intensity (8/(3 pi)) u_x0 Re(G(omega) e^(i (omega t + phi0)))
/// Largest ratio of the intensities: mu, where c is the first-slip radius. Each motion has its own frequency; the phase
/// must be locked. Requires permanent contact inside c, g0(c) <= d0 - rho Delta d.
struct LimitingStresses {
  EdgeStress pressure, traction;
};
LimitingStresses limiting_stresses(const LimitingProfile& profile, const Rheology& body, const Motion& motion, double r,
                                   double time);

}  // namespace fretval::mdr
