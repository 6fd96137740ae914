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
/// distance). It is fitted too, and taken out where it stiffens the largest disc by more than 1e-3 and (h/r)^2, h/r of
/// rings that differ, which no mesh of a half-space does; radii are off by half of what stays in. scatter: largest
/// departure of the fitted discs from that law, in the unit of length: 1e-7 where all rings sit on equal squares, of
/// order h^2/10 on an unstructured mesh. It is what the mesh puts into a radius at random. On another body the force of
/// a punch is not in proportion to its radius, but the edge of m rings lies where it does on a half-space with the same
/// rings (Compliance::half_space). Of equal rings that has as many as it takes to know the law, with two terms more as
/// they are few; all discs follow it. calibration: what that leaves open, by the same for all radii: how far the law
/// with a term less has its edges elsewhere, and the scatter. It is a share of a ring that is the same on all meshes,
/// so neither other rings nor edges elsewhere in them show it: it belongs into the error bar. 0: the radii are of the
/// body itself, or of a half-space with each of its rings.
struct EffectiveRadii {
  Eigen::VectorXd radius;
  double scatter, calibration;
};
EffectiveRadii effective_radii(const Compliance& compliance);

}  // namespace fretval::fem
