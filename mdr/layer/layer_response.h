#pragma once

#include "mdr/layer/layer.h"

namespace fretval::mdr {

/// Displacement of the surface of a layer under a wavy traction, over that of a half-space of the same material,
/// kappa = k H, s = sinh kappa, c = cosh kappa:
///
///   bonded,       D = kappa^2 + 4(1-nu)^2 + (3-4 nu) s^2
///     normal      L = ((3-4 nu) s c - kappa)/D
///     tangential  L = ((1-nu) ((3-4 nu) s c + kappa)/D + tanh kappa)/(2-nu)
///   frictionless
///     normal      L = 2 s^2/(sinh 2 kappa + 2 kappa)
///
/// The tangential one is what MDR's traction of one direction and mean u_x make of the responses along and across the
/// wave. Source: plane waves of Navier's equations in a layer; for the normal ones Johnson, Contact Mechanics (1985),
/// section 5.8. L(0) = 0, but for small kappa it rises like (1-2 nu) kappa/(2(1-nu)^2), and like 2 kappa^3/3 at
/// nu = 1/2 in a bonded layer, whose volume cannot escape; L - 1 falls like e^(-2 kappa) kappa^2.
///
/// Relative accuracy roundoff for every kappa >= 0, without overflow. Throws std::invalid_argument for a bad layer or
/// kappa, and for a tangential motion on a frictionless base, where nothing holds the layer.
double response_ratio(const Layer& layer, Direction direction, double kappa);

/// L - 1, with the relative accuracy of its own small size at large kappa.
double response_ratio_less_one(const Layer& layer, Direction direction, double kappa);

}  // namespace fretval::mdr
