#pragma once

#include <Eigen/Dense>

#include "fem/condensation/compliance.h"

namespace fretval::fem {

/// Radius of the disc that m active rings stand for, m = 0..n_rings: the flat-punch force of m rings over the force per
/// radius, both from the compliance alone. It is r_m - beta h - gamma h^2/r_m, h the width of the last ring and beta
/// 0.10 to 0.15; the force per radius, beta and, for equal rings, gamma are fitted to the middle half of the discs.
/// Without gamma the radii are off by h^2/8.
/// scatter: largest departure of the fitted discs from that law, in the unit of length: 1e-7 where all rings sit on
/// equal squares, of order h^2/10 on an unstructured mesh. It is what the mesh puts into a radius at random.
struct EffectiveRadii {
  Eigen::VectorXd radius;
  double scatter;
};
EffectiveRadii effective_radii(const Compliance& compliance);

}  // namespace fretval::fem
