#pragma once

#include <vector>

#include "mdr/layer/layer_row.h"

namespace fretval::mdr {

/// Elastic normal contact of an unworn indenter with a layer, exact as MDR is exact over a half-space:
///
///   E* (d - g(x)) = q(x) + (1/pi) int_-a^a K(x-y) q(y) dy,   q(a) = 0,   F = 2 int_0^a q dx
///
/// Source: mdr/layer/layer_kernel.h. Validity: small slopes, frictionless contact that is one disc, an image that rises
/// outwards. With the relaxed modulus it is the relaxed state of a viscoelastic layer. Accuracy 1e-12 where the image
/// is analytic between its kinks; of a table that of its cubics, 1e-7. Contacts up to a = 100 H. Lengths in m, forces
/// in N, stresses in Pa. All throw std::invalid_argument for bad arguments.
struct LayerContact {
  Profile profile;
  Layer layer;
  double contact_radius;  ///< a
  double indentation;     ///< d
  double load;            ///< int_0^a q/E* dx, in m^2

  LayerKernel kernel;         ///< normal
  QuadratureRule rule;        ///< on 0 < x < a
  Eigen::ArrayXd at_points;   ///< q/E* at the points of the rule, in m
  Eigen::ArrayXd amplitudes;  ///< of q/E*
};

/// The contact of radius a = contact_radius in m, positive.
LayerContact layer_contact(const Profile& profile, const Layer& layer, double contact_radius,
                           const RowFineness& fineness = {});

/// The contact at an indentation in m, and under a normal force in N with the shear modulus in Pa; both positive.
LayerContact layer_contact_at_depth(const Profile& profile, const Layer& layer, double indentation,
                                    const RowFineness& fineness = {});
LayerContact layer_contact_under_force(const Profile& profile, const Layer& layer, double shear_modulus,
                                       double normal_force, const RowFineness& fineness = {});

/// Normal force F = 2 E* load in N, with the shear modulus in Pa.
double normal_force(const LayerContact& contact, double shear_modulus);

/// Load of the springs, q(x)/E* in m at x >= 0 in m; 0 beyond a.
double spring_load(const LayerContact& contact, double x);

/// p(r) = -(1/pi) int_r^a q'(x)/sqrt(x^2-r^2) dx in Pa at r >= 0 in m: the pressure of independent springs, and what
/// the smooth coupling makes of it.
double pressure(const LayerContact& contact, double shear_modulus, double r);

/// Displacement w(x) of the surface in MDR's coordinates, m: d - g(x) in contact, (1/E*) times the coupling beyond.
double spring_depth(const LayerContact& contact, double x);

/// Flat punch of radius a that moves by 1 m, all of it in contact and sticking in the tangential direction.
struct LayerPunch {
  double radius;
  double load;  ///< int_0^a q/E* dx or q/G*, in m^2; a half-space has a
  double edge;  ///< q/E* or q/G* at a, in m, of which the stresses at the edge are made; a half-space has 1
  LayerKernel kernel;
  Eigen::ArrayXd amplitudes;  ///< of q/E* or q/G*
};
LayerPunch layer_punch(const Layer& layer, Direction direction, double radius, const RowFineness& fineness = {});

/// Stress at r < a under a displacement of 1 m, Pa/m: the stress that is singular at the edge, edge E*/(pi
/// sqrt(a^2-r^2)), and what the coupling adds to it; 0 beyond a. Tangentially with G* for E*.
double punch_stress(const LayerPunch& punch, double shear_modulus, double r);

/// Force over displacement of the punch in N/m, 2 E* load or 2 G* load, with the shear modulus in Pa.
double punch_stiffness(const LayerPunch& punch, double shear_modulus);

}  // namespace fretval::mdr
