#include "mdr/indentation.h"

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <limits>

#include "mdr/checks.h"

namespace fretval::mdr {

namespace {
const double pi = std::acos(-1.0);

double stick_depth_cattaneo_mindlin(double mu, double indentation, double tangential_displacement) {
  require_positive("coefficient of friction", mu);
  require_non_negative("indentation", indentation);
  require_non_negative("tangential displacement", tangential_displacement);
  return std::max(0.0, indentation - 2 * tangential_displacement / (3 * mu));
}

}  // namespace

double contact_radius(const Profile& profile, double indentation) {
  require_non_negative("indentation", indentation);
  return inverse_transform(profile, indentation);
}

double normal_force(const Profile& profile, double shear_modulus, double indentation) {
  require_positive("shear modulus", shear_modulus);
  const double n = profile.exponent;
  return n / (n + 1) * 8 * shear_modulus * contact_radius(profile, indentation) * indentation;
}

double abel_slope_integral(const Profile& profile, double r, double a) {
  const double n = profile.exponent;
  // Below the smallest normal number a/r overflows; no other r is that close to the axis.
  if (r <= a * std::numeric_limits<double>::min()) {
    if (n <= 1) return std::numeric_limits<double>::infinity();
    return transform_slope(profile, a) / (n - 1);
  }
  // x = r cosh(t) removes the root at x = r and leaves an integrand without any singularity, scaled by its value at the
  // upper end against overflow. With 1 + excess = a/r the limit arcosh(a/r) keeps its relative accuracy as r -> a.
  const double excess = (a - r) / r;
  const double limit = std::log1p(excess + std::sqrt(excess) * std::sqrt(2 + excess));
  const auto integrand = [&](double t) { return std::pow(r / a * std::cosh(t), n - 1); };
  // The error estimate is that of the embedded Gauss rule; the Kronrod value itself is good to roundoff.
  return transform_slope(profile, a) *
         boost::math::quadrature::gauss_kronrod<double, 31>::integrate(integrand, 0.0, limit, 12, 1e-11);
}

double pressure(const Profile& profile, double shear_modulus, double indentation, double r) {
  require_positive("shear modulus", shear_modulus);
  require_non_negative("radial coordinate r", r);
  const double a = contact_radius(profile, indentation);
  if (r >= a) return 0;
  return 4 * shear_modulus / pi * abel_slope_integral(profile, r, a);
}

double tangential_force_full_stick(const Profile& profile, double shear_modulus, double indentation,
                                   double tangential_displacement) {
  require_positive("shear modulus", shear_modulus);
  require_non_negative("tangential displacement", tangential_displacement);
  return 16.0 / 3 * shear_modulus * contact_radius(profile, indentation) * tangential_displacement;
}

double stick_radius_cattaneo_mindlin(const Profile& profile, double mu, double indentation,
                                     double tangential_displacement) {
  return inverse_transform(profile, stick_depth_cattaneo_mindlin(mu, indentation, tangential_displacement));
}

double tangential_force_cattaneo_mindlin(const Profile& profile, double shear_modulus, double mu, double indentation,
                                         double tangential_displacement) {
  const double stick_depth = stick_depth_cattaneo_mindlin(mu, indentation, tangential_displacement);
  return mu * (normal_force(profile, shear_modulus, indentation) - normal_force(profile, shear_modulus, stick_depth));
}

}  // namespace fretval::mdr
