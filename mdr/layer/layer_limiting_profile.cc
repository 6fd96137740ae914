#include "mdr/layer/layer_limiting_profile.h"

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>

#include "mdr/support/checks.h"
#include "mdr/support/constants.h"

namespace fretval::mdr {

namespace {

// int_c^r w/sqrt(r^2-x^2) dx of the free surface, x = r sin(angle).
double free_surface_integral(const LayerLimitingProfile& profile, double r) {
  const double c = profile.stick_radius, start = std::atan2(c, std::sqrt((r - c) * (r + c)));
  const int n_panels = panels_on(profile.layer, r - c);
  std::vector<double> breaks;
  for (int k = 0; k <= n_panels; ++k) breaks.push_back(start + (pi / 2 - start) * k / n_panels);
  constexpr int n_points = 20;
  const QuadratureRule rule = gauss_legendre(breaks, n_points);
  return (rule.weight * coupling(profile.kernel, profile.amplitudes, Eigen::ArrayXd(r * rule.point.sin()))).sum();
}

// f_inf - f without regard to the outer radius.
double depth_below_unworn(const LayerLimitingProfile& profile, double r) {
  const double c = profile.stick_radius;
  if (r <= c) return 0;
  const double angle = std::atan2(std::sqrt((r - c) * (r + c)), c);
  return 2 / pi *
         (profile.maximum_indentation * angle - abel_depth_integral(profile.unworn, c, r, r) -
          free_surface_integral(profile, r));
}

double outer_radius_of(const LayerLimitingProfile& profile, double a0, double farthest) {
  constexpr double step = 1.1;
  const auto excess = [&](double r) { return depth_below_unworn(profile, r); };
  if (excess(a0) <= 0) return a0;
  double lower = a0, upper = a0;
  for (; excess(upper) > 0; upper = std::min(upper * step, farthest)) {
    if (upper >= farthest) reject("worn radius in m", farthest, "the worn zone reaches beyond the end of the profile");
    lower = upper;
  }
  std::uintmax_t iterations = 100;
  const auto bracket = boost::math::tools::toms748_solve(excess, lower, upper,
                                                         boost::math::tools::eps_tolerance<double>(45), iterations);
  return (bracket.first + bracket.second) / 2;
}

double beyond_unworn(const LayerLimitingProfile& profile, double indentation) {
  constexpr double roundoff = 1e-9;
  require_within("indentation", indentation, profile.unworn_depth * (1 - roundoff),
                 profile.maximum_indentation * (1 + roundoff));
  return indentation - profile.unworn_depth;
}

}  // namespace

LayerLimitingProfile layer_limiting_profile(const Profile& unworn, const Layer& layer, double stick_radius,
                                            double maximum_indentation) {
  require_positive("maximum indentation", maximum_indentation);
  require_positive("stick radius", stick_radius);
  const double a0 = layer_contact_at_depth(unworn, layer, maximum_indentation).contact_radius;
  constexpr double roundoff = 1e-9, most_of_a0 = 4;
  require_within("stick radius", stick_radius, 0, a0 * (1 + roundoff));
  const double farthest = std::min(most_of_a0 * a0, end_radius(unworn));
  const LayerRow row = layer_row(unworn, layer, Direction::normal, stick_radius, farthest);
  const Eigen::ArrayXd load =
      row.load(row.points().unaryExpr([&](double x) { return maximum_indentation - transform(unworn, x); }));
  LayerLimitingProfile profile{unworn,
                               layer,
                               stick_radius,
                               maximum_indentation,
                               layer_contact(unworn, layer, stick_radius).indentation,
                               farthest,
                               row.kernel(),
                               row.amplitudes_of(load)};
  profile.outer_radius = outer_radius_of(profile, a0, farthest);
  return profile;
}

double worn_depth(const LayerLimitingProfile& profile, double r) {
  require_non_negative("radial coordinate r", r);
  if (r <= profile.stick_radius || r >= profile.outer_radius) return 0;
  return depth_below_unworn(profile, r);
}

double worn_volume(const LayerLimitingProfile& profile) {
  const double c = profile.stick_radius, width = profile.outer_radius - c;
  if (width <= 0) return 0;
  // With r = c + width s^2 the root at c is smooth.
  const auto integrand = [&](double s) {
    const double r = c + width * s * s;
    return worn_depth(profile, r) * r * 2 * width * s;
  };
  constexpr unsigned depth = 6;
  constexpr double accuracy = 1e-9;
  return 2 * pi * boost::math::quadrature::gauss_kronrod<double, 31>::integrate(integrand, 0.0, 1.0, depth, accuracy);
}

double shape(const LayerLimitingProfile& profile, double r) {
  return shape(profile.unworn, r) + worn_depth(profile, r);
}

double transform(const LayerLimitingProfile& profile, double x) {
  if (std::abs(x) <= profile.stick_radius) return transform(profile.unworn, x);
  return profile.maximum_indentation - coupling(profile.kernel, profile.amplitudes, std::abs(x));
}

double limiting_normal_force(const LayerLimitingProfile& profile, double shear_modulus, double indentation) {
  const double beyond = beyond_unworn(profile, indentation);
  const LayerContact contact = layer_contact(profile.unworn, profile.layer, profile.stick_radius);
  return normal_force(contact, shear_modulus) +
         beyond * punch_stiffness(layer_punch(profile.layer, Direction::normal, profile.stick_radius), shear_modulus);
}

double limiting_pressure(const LayerLimitingProfile& profile, double shear_modulus, double indentation, double r) {
  const double beyond = beyond_unworn(profile, indentation);
  const LayerContact contact = layer_contact(profile.unworn, profile.layer, profile.stick_radius);
  const LayerPunch punch = layer_punch(profile.layer, Direction::normal, profile.stick_radius);
  return pressure(contact, shear_modulus, r) + beyond * punch_stress(punch, shear_modulus, r);
}

}  // namespace fretval::mdr
