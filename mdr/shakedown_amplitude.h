#pragma once

#include <optional>

#include "mdr/motion.h"
#include "mdr/rheology.h"

namespace fretval::mdr {

/// The tangential amplitude u_x0 in m whose shakedown depth g(c) (see stick_depths) is the given one; the inverse of
///   g = d0 - (rho/2)(|A e^(i phi0) - Delta d| + |A e^(i phi0) + Delta d|),   A = 2 u_x0/(3 mu)
/// The points A e^(i phi0) of equal g lie on an ellipse with foci +-Delta d and half axis s = (d0 - g)/rho:
///   1/A^2 = cos^2(phi0)/s^2 + sin^2(phi0)/(s^2 - Delta d^2);   phase unlocked: A = s - Delta d.
/// Empty where no amplitude does it: s <= Delta d, the contact opens at that depth in every cycle.
/// The tangential amplitude of the motion is not used. Equal frequencies. Throws std::invalid_argument for bad
/// arguments.
std::optional<double> tangential_amplitude_for_shakedown(const Rheology& body, double mu, const Motion& motion,
                                                         double depth);

}  // namespace fretval::mdr
