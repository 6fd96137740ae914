#pragma once

#include <Eigen/Dense>

#include "fem/condensation/compliance.h"

namespace fretval::fem {

/// Radius of the disc that m active rings stand for, m = 0..n_rings: the flat-punch force of m rings on a half-space
/// over the force per radius, both from the compliance alone. It is r_m - beta h - gamma h^2/r_m, h the width of the
/// last ring and beta 0.10 to 0.15; the force per radius, beta and, for equal rings, gamma are fitted to the middle
/// half of the discs. Without gamma the radii are off by h^2/8. In a body whose far boundary stiffens a punch that is
/// not the force: the first reflection of what the punch sends there displaces all of the surface by the same, in
/// proportion to the force, so 1/F is off by a constant (the next one by the third power of the radius over the
/// distance). This constant is fitted, too, and taken out where it stiffens the largest disc by more than 1e-3 and by
/// more than (h/r)^2 (h/r if the rings differ), which it does on no mesh of a half-space; otherwise it stays in, and
/// radii are off by half of it. scatter: largest departure of the fitted discs from that law, in the unit of length:
/// 1e-7 where all rings sit on equal squares, of order h^2/10 on an unstructured mesh. This is the random error that
/// the mesh puts into a radius.
///
/// On another body the force of a punch, F(r), is not in proportion to its radius. The edge of m rings lies where it
/// does on a half-space with the same rings (Compliance::half_space), but for the second order of the rings: the
/// traction at an edge, K1/sqrt(s) + K2 sqrt(s) at the distance s, moves it by h^2 K2/K1 times a number that depends on
/// the rings alone, while K2/K1 belongs to the body. How far it moves is measured by pairs of rings, whose edges move
/// four times as far (with_wider_rings). As the equal rings of the half-space are few, their edges are fitted by a law
/// with two further terms, which all discs follow. calibration: the error that this leaves, the same for all radii: the
/// distance of the edges from those of the law with one term less, plus the scatter. It is a share of a ring that is
/// the same on all meshes, so that neither other rings nor another place of the edge among them show it: it belongs
/// into the error bar. 0: the radii are of the body itself, or of a half-space with each of its rings.
///
/// of_rings: radius of the contact when ring m touches, which then is half in it; there the depth of the ring belongs
/// (PunchSeries). It lies in the middle between the edges of m and m + 1 rings, and h^2 F''/(24 F') further out: the
/// ring touches at the indentation (P(m + 1) - P(m)) / (F(m + 1) - F(m)), P the force that a profile takes from a
/// punch; the derivatives P' = F' d have this ratio at the middle but for third differences, and the error of P, h^2 F'
/// d'/24, takes part of these away. With of_rings in the middle, forces on a layer would be of second order.
struct EffectiveRadii {
  Eigen::VectorXd radius;
  Eigen::VectorXd of_rings;
  double scatter, calibration;
};
EffectiveRadii effective_radii(const Compliance& compliance);

/// Effective radii of the rings, and of rings of twice the width on the same mesh (with_wider_rings).
struct RadiiByWidth {
  EffectiveRadii rings, wide;
};
RadiiByWidth effective_radii(const Compliance& compliance, const Compliance& wide);

}  // namespace fretval::fem
