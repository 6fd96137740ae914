#pragma once

#include "mdr/motion.h"
#include "mdr/rheology.h"

namespace fretval::mdr {

/// Forces per length in N/m of one element of the foundation that stays in contact and sticks, at the time t in s.
///
///   q_z(t) = 4 G'(0) (d0 - g) + 4 Delta d [G'(w_z) cos(w_z t) - G''(w_z) sin(w_z t)]                    paper (15)
///   q_x(t) = (8/3) u_x0 [G'(w_x) cos(w_x t + phi0) - G''(w_x) sin(w_x t + phi0)]                        paper (16)
///
/// The paper writes Delta F = q Delta x and has one frequency; each motion's own is used here. It sticks as long as
/// |q_x| <= mu q_z, paper (17); compare stick_depths() of mdr/stick_radius.h.
/// depth: g at the element in m. Bad arguments, and a motion without a phase where one is needed, throw
/// std::invalid_argument.

double element_normal_force(const Rheology& body, const Motion& motion, double depth, double time);

/// Needs a phase.
double element_tangential_force(const Rheology& body, const Motion& motion, double time);

}  // namespace fretval::mdr
