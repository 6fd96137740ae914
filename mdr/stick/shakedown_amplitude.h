#pragma once

#include <optional>

#include "mdr/motion/motion.h"
#include "mdr/rheology/rheology.h"

namespace fretval::mdr {

/// The tangential amplitude u_x0 in m whose shakedown depth g(c) (see stick_depths) is the given one; with s = d0 - g,
/// A = 2 u_x0/(3 mu) and rho_z, rho_x = |G|/G0 at the two frequencies:
///   equal frequencies, locked:   the points A e^(i phi0) of equal g lie on an ellipse with foci +-Delta d,
///                                1/A^2 = cos^2(phi0)/(s/rho)^2 + sin^2(phi0)/((s/rho)^2 - Delta d^2)
///   phase unlocked:              A = (s - rho_z Delta d)/rho_x
///   unequal frequencies, locked: the zero of s - (M+ + M-)/2, which is convex in A and so has one
/// Empty where no amplitude does it: s <= rho_z Delta d, the contact opens at that depth in every cycle.
/// The tangential amplitude of the motion is not used. Throws std::invalid_argument for bad arguments.
std::optional<double> tangential_amplitude_for_shakedown(const Rheology& body, double mu, const Motion& motion,
                                                         double depth);

}  // namespace fretval::mdr
