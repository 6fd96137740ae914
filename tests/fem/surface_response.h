#pragma once

#include <cmath>
#include <limits>

#include "fem/support/constants.h"

namespace fretval::fem {

/// Response of the surface of a body of unit shear modulus to a wave of traction of wave number k: displacement per
/// traction, normal, tangential along the wave, and across it. Of a layer bonded to a rigid base, from the equations of
/// elasticity in Fourier space (docs/theory.md); thickness infinite: a half-space.
struct SurfaceResponse {
  double normal, along, across;
};

inline SurfaceResponse surface_response(double k, double nu, double thickness) {
  const double kappa = k * thickness, stiff = 3 - 4 * nu, half_space = (1 - nu) / k;
  if (kappa > 18) return {half_space, half_space, 1 / k};
  const double s = std::sinh(kappa), c = std::cosh(kappa);
  const double below = kappa * kappa + 4 * (1 - nu) * (1 - nu) + stiff * s * s;
  return {half_space * (stiff * s * c - kappa) / below, half_space * (stiff * s * c + kappa) / below,
          std::tanh(kappa) / k};
}

/// Integral over a disc of the displacement that a unit traction on it makes, one direction everywhere:
/// 2 pi a^2 int m(k) J_1(k a)^2 / k dk, of a layer as that of the half-space, 8 a^3 m k/3, and the rest by Simpson's
/// rule.
template <class Response>
double disc_response(const Response& response, double half_space_per_k, double radius, double thickness) {
  const double half_space = 8.0 / 3 * std::pow(radius, 3) * half_space_per_k;
  if (thickness == std::numeric_limits<double>::infinity()) return half_space;
  const int n = 4000;
  const double end = 18 / thickness, step = end / n;
  double rest = -half_space_per_k * radius * radius / 4;  // at k = 0, where a layer hardly gives way
  for (int i = 1; i < n; ++i) {
    const double k = i * step, bessel = std::cyl_bessel_j(1, k * radius);
    rest += (i % 2 == 1 ? 4 : 2) * (response(k) - half_space_per_k / k) * bessel * bessel / k;
  }
  return half_space + 2 * pi * radius * radius * rest * step / 3;
}

}  // namespace fretval::fem
