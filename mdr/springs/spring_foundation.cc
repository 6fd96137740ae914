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
  // g/x + int g/x^2 dx at the same radius, over Delta d; empty: the pressure has no bound.
  std::optional<double> permanent_bend;
};

// The load at an instant: the force over 8 G0 Delta d, and pi times the pressure on the axis over 4 G0 Delta d.
struct Load {
  double force, pressure;
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

// n of g - g(0) ~ x^n at the tip; infinite under a flat face.
double exponent_at_tip(const Depth& g, double outer_radius) {
  const double tip = g(0), x = 1e-4 * outer_radius, height = g(2 * x) - tip;
  return height > 0 ? std::log2(height / (g(x) - tip)) : std::numeric_limits<double>::infinity();
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

// int_0^radius (g - g(0))/x^2 dx.
double curvature_integral(const Depth& g, const std::vector<double>& kinks, double radius) {
  if (radius == 0) return 0;
  const double tip = g(0);
  return sum_between_kinks(kinks, 0, radius, [&](double from, double to) {
    boost::math::quadrature::tanh_sinh<double> quadrature;
    return quadrature.integrate([&](double x) { return (g(x) - tip) / x / x; }, from, to, 1e-10);
  });
}

double bend_integral(const Depth& g, const std::vector<double>& kinks, double radius) {
  return radius == 0 ? 0 : (g(radius) - g(0)) / radius + curvature_integral(g, kinks, radius);
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
          rest_depth_integral(g, kinks, motion.indentation, permanent) / motion.normal_amplitude,
          has_bounded_axis_pressure(g, outer_radius, body, permanent == 0)
              ? std::optional(bend_integral(g, kinks, permanent) / motion.normal_amplitude)
              : std::nullopt};
}

// y of the spring at x, see mdr/springs/periodic_spring.h; the indenter never touches it unless y > -1.
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

// Load of the spring of that relative depth; none where the indenter never touches it.
double load_of_spring(const Foundation& foundation, double theta, double y) {
  return y > -1 ? spring_force(foundation.model, periodic_spring(foundation.model, y), theta) : 0;
}

// Contribution of the springs that lose contact now and then: int s dx and int (inner - s)/x^2 dx of their loads s, up
// to the end of the contact. The substitution x = from + width sin^2(pi s/2) smooths the half-integer powers of the
// distance to either end. Where they reach to the axis, the part of inner - s that is in proportion to g - g(0) is
// integrated by itself: over x^2 it has no bound there for f ~ r^n, n < 2.
Load intermittent_load(const Foundation& foundation, double theta, double inner, double upper) {
  using Gauss = boost::math::quadrature::gauss<double, 30>;
  Load load{0, 0};
  double slope = 0;  // ds/dy of the spring on the axis
  const double on_axis = relative_depth(foundation, 0);
  if (foundation.permanent_radius == 0 && foundation.permanent_bend) {
    const double step = 1e-4 * (1 + on_axis);
    slope = (inner - load_of_spring(foundation, theta, on_axis - step)) / step;
    load.pressure = slope * curvature_integral(foundation.g, foundation.kinks, upper) / foundation.amplitude;
  }
  const auto add = [&](double from, double to, double s, double weight) {
    const double sine = std::sin(pi * s / 2), width = to - from, x = from + width * sine * sine;
    const double dx = weight / 2 * width * pi / 2 * std::sin(pi * s), y = relative_depth(foundation, x);
    const double force = load_of_spring(foundation, theta, y);
    load.force += force * dx;
    load.pressure += (inner - force - slope * (on_axis - y)) / (x * x) * dx;
  };
  sum_between_kinks(foundation.kinks, foundation.permanent_radius, upper, [&](double from, double to) {
    for (std::size_t k = 0; k < Gauss::abscissa().size(); ++k)
      for (const double sign : {-1, 1}) add(from, to, (1 + sign * Gauss::abscissa()[k]) / 2, Gauss::weights()[k]);
    return 0;
  });
  return load;
}

Load load_at(const Foundation& foundation, double angle) {
  const double theta = angle - 2 * pi * std::floor(angle / (2 * pi)), c = foundation.permanent_radius;
  const double edge = std::max(contact_edge(foundation, theta), c), y = relative_depth(foundation, c);
  const double oscillating = harmonic_force(foundation.model, 0, theta);
  const double inner = c > 0 ? y + oscillating : load_of_spring(foundation, theta, y);
  if (edge == 0) return {0, 0};
  Load load = edge > c ? intermittent_load(foundation, theta, inner, edge) : Load{0, 0};
  load.force += foundation.permanent_volume + c * oscillating;
  load.pressure += foundation.permanent_bend.value_or(0) + inner / edge;
  return load;
}

// Largest value of sign times a part of the load, near the sample in which it is largest.
double refined_extremum(const Foundation& foundation, const std::vector<Load>& samples, double Load::*part,
                        double sign) {
  const auto best = std::max_element(samples.begin(), samples.end(), [&](const Load& left, const Load& right) {
    return sign * left.*part < sign * right.*part;
  });
  const double step = 2 * pi / n_time_steps;
  const double angle = step * static_cast<double>(best - samples.begin());
  const auto negative = [&](double theta) { return -sign * (load_at(foundation, theta).*part); };
  const double refined = boost::math::tools::brent_find_minima(negative, angle - step, angle + step, 18).second;
  return sign * std::max(sign * (*best).*part, -refined);
}

// Response without normal oscillation, which has no amplitude to scale with and is at rest.
NormalResponse static_response(const Depth& g, const std::vector<double>& kinks, double outer_radius,
                               const PronyBody& body, const Motion& motion) {
  const double radius = radius_at_depth(g, motion.indentation, outer_radius);
  const double force = 8 * body.relaxed_modulus * rest_depth_integral(g, kinks, motion.indentation, radius);
  const double inner = (motion.indentation - g(radius)) / radius;
  std::optional<AxisPressure> pressure;
  if (has_bounded_axis_pressure(g, outer_radius, body, false))
    pressure = {4 / pi * body.relaxed_modulus * (bend_integral(g, kinks, radius) + inner), 0};
  return {force, force, radius, pressure, {}, {}, {}};
}

NormalResponse oscillating_response(const Depth& g, const std::vector<double>& kinks, double outer_radius,
                                    const PronyBody& body, const Motion& motion) {
  const Foundation foundation = make_foundation(g, kinks, outer_radius, body, motion);
  std::vector<Load> loads;
  for (int k = 0; k < n_time_steps; ++k) loads.push_back(load_at(foundation, 2 * pi * k / n_time_steps));
  loads.push_back(loads.front());
  std::vector<double> force;
  for (const auto& load : loads) force.push_back(foundation.force_scale * load.force);
  const double maximum = foundation.force_scale * refined_extremum(foundation, loads, &Load::force, 1);
  const double minimum = foundation.force_scale * refined_extremum(foundation, loads, &Load::force, -1);
  std::optional<AxisPressure> pressure;
  if (foundation.permanent_bend)
    pressure = {foundation.force_scale / (2 * pi) * refined_extremum(foundation, loads, &Load::pressure, 1), 0};
  return {maximum, minimum, foundation.contact_radius, pressure, {}, {}, std::move(force)};
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

bool has_bounded_axis_pressure(const Depth& g, double outer_radius, const PronyBody& body, bool loses_contact) {
  constexpr double least_exponent = 1 + 1e-3;
  return exponent_at_tip(g, outer_radius) >= least_exponent && !(body.viscosity > 0 && loses_contact);
}

double axis_pressure_gain(const Depth& g, double outer_radius) {
  constexpr double smooth = 2 - 1e-3;
  const double exponent = exponent_at_tip(g, outer_radius);
  return exponent < smooth ? std::exp2(exponent - 1) - 1 : 3;
}

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
