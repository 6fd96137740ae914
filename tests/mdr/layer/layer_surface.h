#pragma once

#include <algorithm>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/special_functions/bessel.hpp>
#include <boost/math/special_functions/ellint_1.hpp>
#include <cmath>
#include <functional>

#include "mdr/support/constants.h"
#include "mdr/support/gauss_legendre.h"
#include "tests/mdr/layer/layer_waves.h"

namespace fretval::mdr {

/// Displacement of the surface of a layer, G = 1, at r under a pressure on s < a, without MDR: the half-space by
/// complete elliptic integrals, what the layer changes by Hankel transforms of the response that the matrix exponential
/// gives. Waves beyond kappa = 8 are left out, some 1e-6 of the whole.
inline double surface_displacement(const Layer& layer, double a, const std::function<double(double)>& p, double r) {
  const double nu = layer.poisson_ratio;
  boost::math::quadrature::tanh_sinh<double> singular;
  const auto ring = [&](double s) {
    return p(s) * s / (r + s) * boost::math::ellint_1(std::min(2 * std::sqrt(r * s) / (r + s), 1 - 1e-16));
  };
  double half_space = r < a ? singular.integrate(ring, r, a, 1e-7) : 0;
  if (r > 0) half_space += singular.integrate(ring, 0.0, std::min(r, a), 1e-7);
  half_space *= 2 * (1 - nu) / pi;
  // s = a sin(angle) takes the root out of the pressure at the edge, also where it is in the denominator.
  const QuadratureRule angle = gauss_legendre({0, pi / 2}, 24);
  const Eigen::ArrayXd s = a * angle.point.sin(), share = angle.weight * s.unaryExpr(p) * s * a * angle.point.cos();
  const QuadratureRule waves = gauss_legendre({0, 1, 2, 4, 8}, 12);
  double change = 0;
  for (Eigen::Index m = 0; m < waves.point.size(); ++m) {
    const double k = waves.point[m] / layer.thickness;
    const double transformed =
        (share * s.unaryExpr([k](double at) { return boost::math::cyl_bessel_j(0, k * at); })).sum();
    change += waves.weight[m] / layer.thickness * (layer_waves(layer, k).normal * k - (1 - nu)) * transformed *
              boost::math::cyl_bessel_j(0, k * r);
  }
  return half_space + change;
}

}  // namespace fretval::mdr
