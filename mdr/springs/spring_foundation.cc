#include "mdr/springs/spring_foundation.h"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "mdr/springs/periodic_spring.h"
#include "mdr/springs/spring_model.h"
#include "mdr/support/checks.h"
#include "mdr/support/constants.h"

namespace fretval::mdr {

namespace {
constexpr int n_time_steps = 128;

using Depth = std::function<double(double)>;

// The springs that carry force at some time: [0, permanent_radius] always, up to contact_radius now and then.
struct Foundation {
  Depth g;
  std::vector<double> kinks;
  double indentation;
  double amplitude;
  SpringModel model;
  double force_scale;  // 8 G0 Delta d
  double permanent_radius;
  double contact_radius;
  double permanent_volume;  // int (d0 - g)/Delta d over [0, permanent_radius]
};

// Where a function falls below zero on [lower, upper]; an end of the interval if it has one sign throughout.
template <class Function>
double edge(const Function& function, double lower, double upper, int n_bits) {
  const double at_upper = function(upper);
  if (at_upper >= 0) return upper;
  const double at_lower = function(lower);
  if (at_lower <= 0) return lower;
  std::uintmax_t iterations = 100;
  const auto bracket = boost::math::tools::toms748_solve(function, lower, upper, at_lower, at_upper,
                                                         boost::math::tools::eps_tolerance<double>(n_bits), iterations);
  return (bracket.first + bracket.second) / 2;
}

double radius_at_depth(const Depth& g, double depth, double outer_radius) {
  return edge([&](double x) { return depth - g(x); }, 0.0, outer_radius, 50);
}

// Sum of integral(from, to) over [lower, upper], cut at the kinks of the profile.
template <class Integral>
double sum_between_kinks(const std::vector<double>& kinks, double lower, double upper, const Integral& integral) {
  double sum = 0;
  for (const double kink : kinks) {
    if (kink <= lower || kink >= upper) continue;
    sum += integral(lower, kink);
    lower = kink;
  }
  return sum + integral(lower, upper);
}

double rest_depth_integral(const Depth& g, const std::vector<double>& kinks, double indentation, double radius) {
  if (radius == 0) return 0;
  return sum_between_kinks(kinks, 0, radius, [&](double from, double to) {
    boost::math::quadrature::tanh_sinh<double> quadrature;
    return quadrature.integrate([&](double x) { return indentation - g(x); }, from, to, 1e-12);
  });
}

Foundation make_foundation(const Depth& g, const std::vector<double>& kinks, double outer_radius, const PronyBody& body,
                           const Motion& motion) {
  SpringModel model = spring_model(body, angular_frequency(motion.normal_frequency));
  const double swing = std::hypot(model.storage, model.loss) * motion.normal_amplitude;
  const double permanent = radius_at_depth(g, motion.indentation - swing, outer_radius);
  return {g,
          kinks,
          motion.indentation,
          motion.normal_amplitude,
          std::move(model),
          8 * body.relaxed_modulus * motion.normal_amplitude,
          permanent,
          radius_at_depth(g, maximum_indentation(motion), outer_radius),
          rest_depth_integral(g, kinks, motion.indentation, permanent) / motion.normal_amplitude};
}

// y of the spring at x, see mdr/periodic_spring.h; the indenter never touches it unless y > -1.
double relative_depth(const Foundation& foundation, double x) {
  return (foundation.indentation - foundation.g(x)) / foundation.amplitude;
}

// Where the contact ends at theta. Ten digits do: the force there is zero, or with a dashpot finite.
double contact_edge(const Foundation& foundation, double theta) {
  const auto margin = [&](double x) {
    const double y = relative_depth(foundation, x);
    return y > -1 ? contact_margin(periodic_spring(foundation.model, y), theta) : -pi;
  };
  return edge(margin, foundation.permanent_radius, foundation.contact_radius, 36);
}

// The share of the springs that lose contact now and then, divided by 8 G0 Delta d. The substitution
// x = from + width sin^2(pi s/2) smooths the half-integer powers of the distance to either end.
double intermittent_force(const Foundation& foundation, double theta) {
  const double lower = foundation.permanent_radius, upper = contact_edge(foundation, theta);
  if (upper <= lower) return 0;
  return sum_between_kinks(foundation.kinks, lower, upper, [&](double from, double to) {
    const double width = to - from;
    const auto integrand = [&](double s) {
      const double sine = std::sin(pi * s / 2);
      const double y = relative_depth(foundation, from + width * sine * sine);
      if (y <= -1) return 0.0;
      const double force = spring_force(foundation.model, periodic_spring(foundation.model, y), theta);
      return force * width * pi / 2 * std::sin(pi * s);
    };
    return boost::math::quadrature::gauss<double, 30>::integrate(integrand, 0.0, 1.0);
  });
}

double normal_force(const Foundation& foundation, double angle) {
  const double theta = angle - 2 * pi * std::floor(angle / (2 * pi));
  const double permanent =
      foundation.permanent_volume + foundation.permanent_radius * harmonic_force(foundation.model, 0, theta);
  return foundation.force_scale * (permanent + intermittent_force(foundation, theta));
}

// Largest value of sign F near the sample that is largest.
double refined_extremum(const Foundation& foundation, const std::vector<double>& samples, double sign) {
  const auto best = std::max_element(samples.begin(), samples.end(),
                                     [&](double left, double right) { return sign * left < sign * right; });
  const double step = 2 * pi / n_time_steps;
  const double angle = step * static_cast<double>(best - samples.begin());
  const auto negative = [&](double theta) { return -sign * normal_force(foundation, theta); };
  const double refined = boost::math::tools::brent_find_minima(negative, angle - step, angle + step, 18).second;
  return sign * std::max(sign * *best, -refined);
}

// Without normal oscillation there is no amplitude to scale with, and nothing to wait for.
NormalResponse static_response(const Depth& g, const std::vector<double>& kinks, double outer_radius,
                               const PronyBody& body, const Motion& motion) {
  const double radius = radius_at_depth(g, motion.indentation, outer_radius);
  const double force = 8 * body.relaxed_modulus * rest_depth_integral(g, kinks, motion.indentation, radius);
  return {force, force, radius, {}, {}, {}};
}

NormalResponse oscillating_response(const Depth& g, const std::vector<double>& kinks, double outer_radius,
                                    const PronyBody& body, const Motion& motion) {
  const Foundation foundation = make_foundation(g, kinks, outer_radius, body, motion);
  std::vector<double> force;
  force.reserve(n_time_steps + 1);
  for (int k = 0; k < n_time_steps; ++k) force.push_back(normal_force(foundation, 2 * pi * k / n_time_steps));
  force.push_back(force.front());
  const double maximum = refined_extremum(foundation, force, 1);
  const double minimum = refined_extremum(foundation, force, -1);
  return {maximum, minimum, foundation.contact_radius, {}, {}, std::move(force)};
}

void check_arguments(const Depth& g, double outer_radius, const PronyBody& body, const Motion& motion) {
  validate(body);
  validate(motion);
  require_positive("outer radius", outer_radius);
  const double tip = g(0);
  require_non_negative("one-dimensional profile at x = 0", tip);
  if (tip >= maximum_indentation(motion)) {
    reject("one-dimensional profile at x = 0", tip, "must be less than the maximum indentation");
  }
  require_within("one-dimensional profile at the outer radius", g(outer_radius), tip,
                 std::numeric_limits<double>::max());
}

}  // namespace

NormalResponse periodic_normal_response(const std::function<double(double)>& g, double outer_radius,
                                        const PronyBody& body, const Motion& motion, const std::vector<double>& kinks) {
  check_arguments(g, outer_radius, body, motion);
  NormalResponse response = motion.normal_amplitude > 0 ? oscillating_response(g, kinks, outer_radius, body, motion)
                                                        : static_response(g, kinks, outer_radius, body, motion);
  response.normal_force.resize(n_time_steps + 1, response.normal_force_max);
  for (int k = 0; k <= n_time_steps; ++k) {
    const double cycle = static_cast<double>(k) / n_time_steps;
    response.time.push_back(cycle / motion.normal_frequency);
    response.indentation.push_back(motion.indentation + motion.normal_amplitude * std::cos(2 * pi * cycle));
  }
  return response;
}

}  // namespace fretval::mdr
