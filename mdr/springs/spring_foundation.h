#pragma once

#include <functional>
#include <vector>

#include "mdr/motion/motion.h"
#include "mdr/rheology/prony_body.h"

namespace fretval::mdr {

/// Normal response in the periodic state.
struct NormalResponse {
  double normal_force_max;    ///< N
  double normal_force_min;    ///< N
  double contact_radius_max;  ///< m
  /// One cycle in equal steps, both ends included; time 0 is the deepest position, d = d0 + Delta d cos(omega t).
  std::vector<double> time;          ///< s
  std::vector<double> indentation;   ///< m
  std::vector<double> normal_force;  ///< N
};

/// Normal force of the viscoelastic spring foundation under the oscillating indenter:
///
///   F(t) = 2 int_0^outer q(x,t) dx,   q = 4 int G(t-t') u'(t') dt',   q >= 0,  u >= d(t) - g(x),  q (u - d + g) = 0
///
/// Source: paper, equations (5), (8) and (11); the unilateral condition is on the force, so a spring lifts off although
/// the indenter is still below its rest height. Springs with g <= d0 - rho Delta d keep contact and are summed in
/// closed form in time; the others are integrated by Gauss quadrature up to the edge of the contact at each instant.
/// The result is the periodic state, which does not depend on the start; it is computed as such (mdr/periodic_spring.h)
/// rather than by marching through transients. Relative accuracy 1e-10 of
/// normal_force_max for any omega tau and a profile that is smooth or a cone, 1e-9 for a cusp.
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
