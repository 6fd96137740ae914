#include "mdr/layer/layer_contact.h"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>

#include "mdr/motion/force_control.h"
#include "mdr/support/checks.h"
#include "mdr/support/constants.h"

namespace fretval::mdr {

namespace {

Eigen::ArrayXd images(const Profile& profile, const Eigen::ArrayXd& x) {
  return x.unaryExpr([&](double at) { return transform(profile, at); });
}

// A sphere is steep beyond bounds at its own radius.
double farthest_radius(const Profile& profile) {
  return end_radius(profile) * (1 - 1e-12);
}

// The radius at which a quantity that rises with it has a value; start: a guess.
double radius_with(const std::function<double(double)>& excess, const Profile& profile, double start) {
  constexpr double step = 1.25;
  const double end = farthest_radius(profile);
  double lower = std::min(start, end), upper = lower;
  for (; excess(lower) > 0; lower /= step) upper = lower;
  for (; excess(upper) < 0; upper = std::min(upper * step, end)) {
    if (upper >= end) reject("contact radius in m", end, "the contact would reach beyond the end of the profile");
    lower = upper;
  }
  if (lower == upper) return lower;
  std::uintmax_t iterations = 100;
  const auto bracket = boost::math::tools::toms748_solve(excess, lower, upper,
                                                         boost::math::tools::eps_tolerance<double>(48), iterations);
  return (bracket.first + bracket.second) / 2;
}

// int_r^a of the slope of the coupling over sqrt(x^2-r^2).
double coupled_slope_integral(const LayerKernel& kernel, const Eigen::ArrayXd& amplitudes, double r, double a) {
  // With x^2 = r^2 + s^2 the root is gone, and the slope over x is as smooth as the coupling is even.
  const double end = std::sqrt((a - r) * (a + r));
  const int n_panels = panels_on(kernel.layer, end);
  std::vector<double> breaks;
  for (int k = 0; k <= n_panels; ++k) breaks.push_back(end * k / n_panels);
  constexpr int n_points = 20;
  const QuadratureRule rule = gauss_legendre(breaks, n_points);
  double coupled = 0;
  for (Eigen::Index j = 0; j < rule.point.size(); ++j) {
    const double x = std::hypot(r, rule.point[j]);
    coupled += rule.weight[j] * coupling_slope(kernel, amplitudes, x) / x;
  }
  return coupled;
}

}  // namespace

LayerContact layer_contact(const Profile& profile, const Layer& layer, double contact_radius,
                           const RowFineness& fineness) {
  require_positive("contact radius", contact_radius);
  const QuadratureRule rule = gauss_legendre(row_breaks(profile, layer, contact_radius), fineness.points_of_panel);
  const LayerRow row(layer_kernel(layer, Direction::normal, 2 * contact_radius), rule);
  const Eigen::ArrayXd unit = row.load(Eigen::ArrayXd::Ones(rule.point.size()));
  const Eigen::ArrayXd image = row.load(images(profile, rule.point));
  const auto at_edge = [&](double depth, const Eigen::ArrayXd& load) {
    return depth - coupling(row.kernel(), row.amplitudes_of(load), contact_radius);
  };
  const double d = at_edge(transform(profile, contact_radius), image) / at_edge(1, unit);
  const Eigen::ArrayXd load = d * unit - image;
  return {profile, layer, contact_radius, d, row.integral(load), row.kernel(), rule, load, row.amplitudes_of(load)};
}

LayerContact layer_contact_at_depth(const Profile& profile, const Layer& layer, double indentation,
                                    const RowFineness& fineness) {
  require_positive("indentation", indentation);
  const auto excess = [&](double a) { return layer_contact(profile, layer, a, fineness).indentation - indentation; };
  const double end = farthest_radius(profile);
  const double deepest = std::isfinite(end) ? transform(profile, end) : indentation;
  const double guess = inverse_transform(profile, std::min(indentation, deepest));
  return layer_contact(profile, layer, radius_with(excess, profile, guess), fineness);
}

LayerContact layer_contact_under_force(const Profile& profile, const Layer& layer, double shear_modulus,
                                       double normal_force, const RowFineness& fineness) {
  require_positive("shear modulus", shear_modulus);
  require_positive("normal force", normal_force);
  const double load = normal_force / (2 * spring_modulus(Direction::normal, layer.poisson_ratio) * shear_modulus);
  const auto excess = [&](double a) { return layer_contact(profile, layer, a, fineness).load - load; };
  constexpr double unit_modulus = 1, springs_of_half_space = 8;
  const double depth = indentation_for_force(profile, unit_modulus, springs_of_half_space * load);
  return layer_contact(profile, layer, radius_with(excess, profile, inverse_transform(profile, depth)), fineness);
}

double normal_force(const LayerContact& contact, double shear_modulus) {
  require_positive("shear modulus", shear_modulus);
  return 2 * spring_modulus(Direction::normal, contact.layer.poisson_ratio) * shear_modulus * contact.load;
}

double spring_depth(const LayerContact& contact, double x) {
  require_non_negative("coordinate x", x);
  if (x <= contact.contact_radius) return contact.indentation - transform(contact.profile, x);
  return coupling(contact.kernel, contact.amplitudes, x);
}

double spring_load(const LayerContact& contact, double x) {
  if (x >= contact.contact_radius) return 0;
  return spring_depth(contact, x) - coupling(contact.kernel, contact.amplitudes, x);
}

double pressure(const LayerContact& contact, double shear_modulus, double r) {
  require_positive("shear modulus", shear_modulus);
  require_non_negative("radial coordinate r", r);
  const double a = contact.contact_radius;
  if (r >= a) return 0;
  return spring_modulus(Direction::normal, contact.layer.poisson_ratio) * shear_modulus / pi *
         (abel_slope_integral(contact.profile, r, a) +
          coupled_slope_integral(contact.kernel, contact.amplitudes, r, a));
}

LayerPunch layer_punch(const Layer& layer, Direction direction, double radius, const RowFineness& fineness) {
  require_positive("radius of the punch", radius);
  const LayerRow row = layer_row(parabola(1), layer, direction, radius, radius, fineness);
  const Eigen::ArrayXd load = row.load(Eigen::ArrayXd::Ones(row.points().size()));
  const Eigen::ArrayXd amplitudes = row.amplitudes_of(load);
  return {radius, row.integral(load), 1 - coupling(row.kernel(), amplitudes, radius), row.kernel(), amplitudes};
}

double punch_stress(const LayerPunch& punch, double shear_modulus, double r) {
  require_positive("shear modulus", shear_modulus);
  require_non_negative("radial coordinate r", r);
  const double a = punch.radius;
  if (r >= a) return 0;
  return spring_modulus(punch.kernel.direction, punch.kernel.layer.poisson_ratio) * shear_modulus / pi *
         (punch.edge / std::sqrt((a - r) * (a + r)) + coupled_slope_integral(punch.kernel, punch.amplitudes, r, a));
}

double punch_stiffness(const LayerPunch& punch, double shear_modulus) {
  require_positive("shear modulus", shear_modulus);
  return 2 * spring_modulus(punch.kernel.direction, punch.kernel.layer.poisson_ratio) * shear_modulus * punch.load;
}

}  // namespace fretval::mdr
