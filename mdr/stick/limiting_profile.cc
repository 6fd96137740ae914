#include "mdr/stick/limiting_profile.h"

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>

#include "mdr/profiles/indentation.h"
#include "mdr/support/checks.h"
#include "mdr/support/constants.h"

namespace fretval::mdr {

namespace {

// (13) minus f0 = (2/pi) int_c^r (d_max - g0)/sqrt(r^2-x^2) dx, without regard to the outer radius.
double depth_below_unworn(const Profile& unworn, double c, double maximum_indentation, double r) {
  const double angle = std::atan2(std::sqrt((r - c) * (r + c)), c);  // arccos(c/r), accurate as r -> c
  return 2 / pi * (maximum_indentation * angle - abel_depth_integral(unworn, c, r, r));
}

// The largest radius is where nothing sticks, and at most pi/2 a0 for the bluntest profiles; more for cusps.
double bracket_outer_radius(const Profile& unworn, double c, double maximum_indentation, double a0) {
  const double end = end_radius(unworn);
  double r = a0;
  while (r < end) {
    r = std::min(1.25 * r, end);
    if (depth_below_unworn(unworn, c, maximum_indentation, r) < 0) return r;
  }
  if (std::holds_alternative<Sphere>(unworn)) reject("radius of the sphere", end, "the worn zone would reach it");
  reject("last radius of the profile table", end,
         "the worn zone reaches beyond it; continue the table to at least 1.6 times the contact radius");
}

double find_outer_radius(const Profile& unworn, double c, double maximum_indentation) {
  const double a0 = inverse_transform(unworn, maximum_indentation);
  const auto excess = [&](double r) { return depth_below_unworn(unworn, c, maximum_indentation, r); };
  const double excess_a0 = excess(a0);
  // Nothing, or nothing above roundoff, is worn when c reaches a0.
  if (excess_a0 <= 0) return a0;
  const double upper = bracket_outer_radius(unworn, c, maximum_indentation, a0);
  std::uintmax_t iterations = 100;
  const auto bracket = boost::math::tools::toms748_solve(excess, a0, upper, excess_a0, excess(upper),
                                                         boost::math::tools::eps_tolerance<double>(52), iterations);
  return (bracket.first + bracket.second) / 2;
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

double worn_volume(const LimitingProfile& profile) {
  const double c = profile.stick_radius, width = profile.outer_radius - c;
  if (width <= 0) return 0;
  // With r = c + width s^2 the root at c is smooth.
  const auto integrand = [&](double s) {
    const double r = c + width * s * s;
    return worn_depth(profile, r) * r * 2 * width * s;
  };
  constexpr unsigned depth = 8;
  constexpr double accuracy = 1e-10;
  return 2 * pi * boost::math::quadrature::gauss_kronrod<double, 31>::integrate(integrand, 0.0, 1.0, depth, accuracy);
}

double shape(const LimitingProfile& profile, double r) {
  return shape(profile.unworn, r) + worn_depth(profile, r);
}

double transform(const LimitingProfile& profile, double x) {
  const double unworn = transform(profile.unworn, x);
  return std::abs(x) <= profile.stick_radius ? unworn : profile.maximum_indentation;
}

double limiting_normal_force(const LimitingProfile& profile, double shear_modulus, double indentation) {
  // A caller's own d0 + Delta d may exceed d_max by roundoff.
  require_within("indentation", indentation, 0, profile.maximum_indentation * (1 + 1e-12));
  require_positive("shear modulus", shear_modulus);
  const double c = profile.stick_radius;
  if (indentation <= transform(profile.unworn, c)) return normal_force(profile.unworn, shear_modulus, indentation);
  return 8 * shear_modulus * (c * indentation - transform_integral(profile.unworn, c));
}

}  // namespace fretval::mdr
