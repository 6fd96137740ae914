#pragma once

#include "mdr/motion/motion.h"
#include "mdr/rheology/rheology.h"

namespace fretval::mdr {

/// One element of the foundation that stays in contact and sticks, at the time t in s: its displacements in m and
/// forces per length in N/m.
///
///   u_z(t) = d0 - g + Delta d cos(w_z t),   u_x(t) = u_x0 cos(w_x t + phi0)                   paper (8), (11), (14)
///   q_z(t) = 4 G'(0) (d0 - g) + 4 Delta d [G'(w_z) cos(w_z t) - G''(w_z) sin(w_z t)]                    paper (15)
///   q_x(t) = (8/3) u_x0 [G'(w_x) cos(w_x t + phi0) - G''(w_x) sin(w_x t + phi0)]                        paper (16)
///
/// The paper writes Delta F = q Delta x and has one frequency; each motion's own is used here.
/// depth: g at the element in m. Bad arguments, and a motion without a phase where one is needed, throw
/// std::invalid_argument.

struct ElementDisplacement {
  double normal, tangential;
};

/// Needs a phase.
ElementDisplacement element_displacement(const Motion& motion, double depth, double time);

double element_normal_force(const Rheology& body, const Motion& motion, double depth, double time);

/// Needs a phase.
double element_tangential_force(const Rheology& body, const Motion& motion, double time);

/// mu q_z - |q_x|, paper (17): the element sticks as long as this is not negative; compare stick_depths() of
/// mdr/stick/stick_radius.h. Needs a phase. mu positive.
double element_friction_margin(const Rheology& body, double mu, const Motion& motion, double depth, double time);

}  // namespace fretval::mdr
