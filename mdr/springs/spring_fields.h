#pragma once

#include "mdr/springs/spring_bed.h"
#include "mdr/springs/spring_step.h"
#include "mdr/support/piecewise_cubic.h"

namespace fretval::mdr {

/// Fields on the surface of the three-dimensional body that belong to a state of the springs, for any history:
///
///   p(r) = -(1/pi) int_r q_z'(x)/sqrt(x^2-r^2) dx,     u_z(r) = (2/pi) int_0^r u_z(x)/sqrt(r^2-x^2) dx
///
/// and the same for tau and u_x. Loads and displacements are linear between the springs, constant up to the first one;
/// loads are zero at the end of the bed. Errors are of second order in the width of a spring; of first order and local
/// where the load jumps, at the edge of a worn contact, whose fields are in closed form in mdr/stick/surface_fields.h.
/// Source: paper, equation (4); Popov and Hess (2015), chapters 3 and 5. SI units.
struct SpringFields {
  PiecewiseCubic normal_load_slope, tangential_load_slope;  ///< -q'/pi
  PiecewiseCubic normal_depth, tangential_shift;            ///< u_z, u_x of the springs
};

SpringFields spring_fields(const SpringBed& bed, const PronyBody& body, const SpringState& state);

/// p, tau in Pa and u_z, u_x in m at r >= 0; beyond the bed stresses are zero, and displacements those of springs at
/// rest there. Throw std::invalid_argument for a bad r.
double pressure(const SpringFields& fields, double r);
double traction(const SpringFields& fields, double r);
double normal_displacement(const SpringFields& fields, double r);
double tangential_displacement(const SpringFields& fields, double r);

}  // namespace fretval::mdr
