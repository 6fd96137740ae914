#include "mdr/limiting_profile.h"

#include <boost/math/special_functions/beta.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>

#include "mdr/checks.h"
#include "mdr/indentation.h"

namespace fretval::mdr {

namespace {
const double pi = std::acos(-1.0);

// (13) minus f0, without regard to the outer radius. With s^2 = 1 - c^2/r^2 both terms are written in s, because
// arccos(c/r) and the incomplete beta function of c^2/r^2 lose all digits as r -> c.
//   worn depth = (2/pi) [d_max arcsin(s) - g0(r)/2 B(s^2; 1/2, (n+1)/2)]
double depth_below_unworn(const Profile& unworn, double c, double maximum_indentation, double r) {
  const double s = std::sqrt((r - c) * (r + c)) / r;
  if (s == 0) return 0;
  const double inner = transform(unworn, r) / 2 * boost::math::beta(0.5, (unworn.exponent + 1) / 2, s * s);
  return 2 / pi * (maximum_indentation * std::asin(s) - inner);
}

// The outer radius grows as the stick radius shrinks, up to a0 (pi / B(1/2, (n+1)/2))^(1/n) at c = 0.
double find_outer_radius(const Profile& unworn, double c, double maximum_indentation) {
  const double a0 = inverse_transform(unworn, maximum_indentation);
  const double n = unworn.exponent;
  const double upper = 1.001 * a0 * std::pow(pi / boost::math::beta(0.5, (n + 1) / 2), 1 / n);
  const auto excess = [&](double r) { return depth_below_unworn(unworn, c, maximum_indentation, r); };
  const double excess_a0 = excess(a0);
  // Nothing, or nothing above roundoff, is worn when c reaches a0.
  if (excess_a0 <= 0) return a0;
  std::uintmax_t iterations = 100;
  const auto bracket = boost::math::tools::toms748_solve(excess, a0, upper, excess_a0, excess(upper),
                                                         boost::math::tools::eps_tolerance<double>(52), iterations);
  return (bracket.first + bracket.second) / 2;
}

void check_indentation(const LimitingProfile& profile, double indentation) {
  // A caller's own d0 + Delta d may exceed d_max by roundoff.
  require_within("indentation", indentation, 0, profile.maximum_indentation * (1 + 1e-12));
}

}  // namespace

LimitingProfile limiting_profile(const Profile& unworn, double stick_radius, double maximum_indentation) {
  require_positive("maximum indentation", maximum_indentation);
  require_positive("stick radius", stick_radius);
  require_within("stick radius", stick_radius, 0, inverse_transform(unworn, maximum_indentation));
  return {unworn, stick_radius, maximum_indentation, find_outer_radius(unworn, stick_radius, maximum_indentation)};
}

double worn_depth(const LimitingProfile& profile, double r) {
  require_non_negative("radial coordinate r", r);
  if (r <= profile.stick_radius || r >= profile.outer_radius) return 0;
  return depth_below_unworn(profile.unworn, profile.stick_radius, profile.maximum_indentation, r);
}

double shape(const LimitingProfile& profile, double r) {
  return shape(profile.unworn, r) + worn_depth(profile, r);
}

double transform(const LimitingProfile& profile, double x) {
  const double unworn = transform(profile.unworn, x);
  return std::abs(x) <= profile.stick_radius ? unworn : profile.maximum_indentation;
}

double limiting_normal_force(const LimitingProfile& profile, double shear_modulus, double indentation) {
  check_indentation(profile, indentation);
  require_positive("shear modulus", shear_modulus);
  const double stick_depth = transform(profile.unworn, profile.stick_radius);
  if (indentation <= stick_depth) return normal_force(profile.unworn, shear_modulus, indentation);
  return 8 * shear_modulus * profile.stick_radius * (indentation - stick_depth / (profile.unworn.exponent + 1));
}

double limiting_pressure(const LimitingProfile& profile, double shear_modulus, double indentation, double r) {
  check_indentation(profile, indentation);
  require_positive("shear modulus", shear_modulus);
  require_non_negative("radial coordinate r", r);
  const double c = profile.stick_radius;
  const double jump = indentation - transform(profile.unworn, c);
  if (jump <= 0) return pressure(profile.unworn, shear_modulus, indentation, r);
  if (r > c) return 0;
  const double smooth = r < c ? abel_slope_integral(profile.unworn, r, c) : 0;
  return 4 * shear_modulus / pi * (smooth + jump / std::sqrt((c - r) * (c + r)));
}

}  // namespace fretval::mdr
