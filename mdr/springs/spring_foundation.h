#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "mdr/motion/motion.h"
#include "mdr/rheology/prony_body.h"

namespace fretval::mdr {

/// The largest p(0, t), in Pa.
struct AxisPressure {
  double largest;
  double error;  ///< of springs that were stepped in time; 0: closed form
};

/// Normal response in the periodic state.
struct NormalResponse {
  double normal_force_max;                    ///< N
  double normal_force_min;                    ///< N
  double contact_radius_max;                  ///< m
  std::optional<AxisPressure> axis_pressure;  ///< empty: infinite
  /// One cycle in equal steps, both ends included; time 0 is the deepest position, d = d0 + Delta d cos(omega t).
  std::vector<double> time;          ///< s
  std::vector<double> indentation;   ///< m
  std::vector<double> normal_force;  ///< N
  double normal_force_error = 0;     ///< N, of the largest, of springs that were stepped in time; 0: closed form
  double contact_radius_error = 0;   ///< m, likewise
};

/// Whether the pressure on the axis has a bound: not under a sharp tip, g ~ x^n with n <= 1 (a cone, a cusp), and not
/// where contact is lost and a body with a dashpot is touched anew: its first load stands on a point.
bool has_bounded_axis_pressure(const std::function<double(double)>& g, double outer_radius, const PronyBody& body,
                               bool loses_contact);

/// By what the error of the axis pressure by stepped springs falls as they become half as wide, less 1: 3, and under
/// f ~ r^n, n < 2, 2^(n-1) - 1 (see axis_weights).
double axis_pressure_gain(const std::function<double(double)>& g, double outer_radius);

/// Normal force of the viscoelastic spring foundation under the oscillating indenter:
///
///   F(t) = 2 int_0^outer q(x,t) dx,   q = 4 int G(t-t') u'(t') dt',   q >= 0,  u >= d(t) - g(x),  q (u - d + g) = 0
///
/// Source: paper, equations (5), (8) and (11); the unilateral condition is on the force, so a spring lifts off although
/// the indenter is still below its rest height. Springs with g <= d0 - rho Delta d keep contact and are summed in
/// closed form in time; the others are integrated by Gauss quadrature up to the edge of the contact at each instant.
/// The result is the periodic state, which does not depend on the start; it is computed as such
/// (mdr/springs/periodic_spring.h) rather than by marching through transients. Relative accuracy 1e-10 of
/// normal_force_max for any omega tau and a profile that is smooth or a cone, 1e-9 for a cusp.
///
/// The pressure on the axis, p(0) = -(1/pi) int q'(x)/x dx, by parts over the springs up to c, which keep contact, and
/// those beyond, up to the edge e of the contact:
///
///   pi p(0) = 4 G0 (g(c)/c + int_0^c g/x^2 dx) + q(c)/e + int_c^e (q(c) - q)/x^2 dx
///
/// which knows no slope of q and holds where the load jumps at the edge. Infinite unless
/// has_bounded_axis_pressure. Relative accuracy 1e-8.
///
/// g: one-dimensional profile in m, continuous and not decreasing on [0, outer_radius], 0 <= g(0) < d0 + Delta d.
/// outer_radius in m, positive: where the springs end. Unworn profile: the contact radius at d0 + Delta d; limiting
/// profile: its stick radius, since the springs beyond carry no force. The tangential motion does not matter.
/// kinks: where g is not smooth (transform_kinks), rising; the integrals are cut there.
/// Throws std::invalid_argument for bad arguments, std::runtime_error when a spring does not become periodic.
NormalResponse periodic_normal_response(const std::function<double(double)>& g, double outer_radius,
                                        const PronyBody& body, const Motion& motion,
                                        const std::vector<double>& kinks = {});

}  // namespace fretval::mdr
