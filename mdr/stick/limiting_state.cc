#include "mdr/stick/limiting_state.h"

#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <complex>
#include <cstdint>
#include <stdexcept>

#include "mdr/motion/force_control.h"
#include "mdr/profiles/indentation.h"
#include "mdr/stick/stick_demands.h"
#include "mdr/support/checks.h"

namespace fretval::mdr {

namespace {

// An oscillation as the amplitude of the element's force over 4 G0 (normal) or 4 G0 mu (tangential), in m; under force
// control this times c, in m^2, is what is fixed.
struct Amplitude {
  double value;
  bool is_force;
};

double at_radius(const Amplitude& amplitude, double c) {
  return amplitude.is_force ? amplitude.value / c : amplitude.value;
}

struct Problem {
  const Profile& profile;
  double relaxed_modulus;
  bool force_controlled;  // normal direction
  double mean;            // d0, or F0/(8 G0)
  Amplitude normal;
  Amplitude tangential;
  std::optional<double> phase;  // of the tangential force ahead of the normal one
  StickCriterion criterion;
};

Problem problem_of(const Profile& profile, const Rheology& body, double mu, const FrettingControl& control,
                   StickCriterion criterion) {
  const double relaxed = relaxed_modulus(body);
  const auto normal_ratio = complex_modulus_ratio(body, angular_frequency(control.normal_frequency));
  const auto tangential_ratio = complex_modulus_ratio(body, angular_frequency(control.tangential_frequency));
  Problem problem{profile, relaxed, false, 0, {0, false}, {0, false}, control.phase, criterion};
  if (const auto* force = std::get_if<NormalForceControl>(&control.normal)) {
    problem.force_controlled = true;
    problem.mean = force->mean / (8 * relaxed);
    problem.normal = {force->amplitude / (8 * relaxed), true};
  } else {
    const auto& indentation = std::get<IndentationControl>(control.normal);
    problem.mean = indentation.mean;
    problem.normal = {std::abs(normal_ratio) * indentation.amplitude, false};
    if (problem.phase) *problem.phase -= std::arg(normal_ratio);
  }
  if (const auto* force = std::get_if<TangentialForceControl>(&control.tangential)) {
    problem.tangential = {force->amplitude / (8 * relaxed * mu), true};
  } else {
    const auto& displacement = std::get<TangentialDisplacementControl>(control.tangential);
    problem.tangential = {std::abs(tangential_ratio) * 2 * displacement.amplitude / (3 * mu), false};
    if (problem.phase) *problem.phase += std::arg(tangential_ratio);
  }
  return problem;
}

// The relaxed compression d0 - g(c) that an element at the edge needs, when tangential and normal oscillate so.
double demand(const Problem& problem, double tangential, double normal) {
  const StickDemands demands =
      problem.phase ? locked_demands(tangential, normal, *problem.phase) : unlocked_demands(tangential, normal);
  return problem.criterion == StickCriterion::shakedown ? shakedown_demand(demands) : first_slip_demand(demands);
}

// c g(c) - int_0^c g dx: normal force of the unworn contact of radius c over 8 G0.
double unworn_load(const Profile& profile, double c) {
  return normal_force(profile, 1, transform(profile, c)) / 8;
}

// The zero of a function with f(lower) >= 0 and f(upper) <= 0.
template <class Function>
double root_between(const Function& f, double lower, double upper) {
  std::uintmax_t iterations = 200;
  const auto bracket =
      boost::math::tools::toms748_solve(f, lower, upper, boost::math::tools::eps_tolerance<double>(52), iterations);
  return (bracket.first + bracket.second) / 2;
}

// The load mean - unworn_load carried beyond the unworn contact falls with c, and what the edge needs, c times demand,
// rises with it: one crossing at most.
std::optional<double> radius_under_normal_force(const Problem& problem) {
  const auto surplus = [&](double c) {
    const auto times_c = [c](const Amplitude& amplitude) {
      return amplitude.is_force ? amplitude.value : amplitude.value * c;
    };
    return problem.mean - unworn_load(problem.profile, c) -
           demand(problem, times_c(problem.tangential), times_c(problem.normal));
  };
  if (surplus(0) <= 0) return std::nullopt;
  const double unworn = contact_radius(problem.profile, indentation_for_force(problem.profile, 1, 8 * problem.mean));
  if (surplus(unworn) >= 0) return unworn;
  return root_between(surplus, 0, unworn);
}

// Depth that an edge at c under a prescribed indentation could have and still stick.
double sticking_depth(const Problem& problem, double c) {
  return problem.mean - demand(problem, at_radius(problem.tangential, c), at_radius(problem.normal, c));
}

// Follows wear to the limiting radius: the contact shrinks to the zone that sticks, whose load rises thereby. The depth
// that sticks rises with c, so that this iteration descends from the unworn radius to the largest solution and never
// passes it, whatever the profile. Its last digits may come slowly: they are left to a bracket as soon as the steps
// tell how far the solution is.
std::optional<double> radius_under_indentation(const Problem& problem) {
  const auto surplus = [&](double c) { return sticking_depth(problem, c) - transform(problem.profile, c); };
  const double bracket_width = 1e-3;
  double c = contact_radius(problem.profile, problem.mean), last_step = 0;
  for (int i = 0; i < 1000000; ++i) {
    const double depth = sticking_depth(problem, c);
    if (depth <= 0) return std::nullopt;
    const double sticking = inverse_transform(problem.profile, depth);
    if (!problem.tangential.is_force || !(sticking < c)) return sticking;
    const double step = c - sticking;
    c = sticking;
    if (step < last_step) {
      const double remaining = step * step / (last_step - step);
      const double below = c - 2 * remaining;
      if (2 * remaining < bracket_width * c && surplus(below) >= 0 && surplus(c) < 0)
        return root_between(surplus, below, c);
    }
    last_step = step;
  }
  throw std::runtime_error("the stick radius was not found: the load is within roundoff of the largest that sticks");
}

LimitingState state_at(const Problem& problem, const Rheology& body, double mu, const FrettingControl& control,
                       double c) {
  const double depth = transform(problem.profile, c), load = unworn_load(problem.profile, c);
  const double indentation = problem.force_controlled ? depth + (problem.mean - load) / c : problem.mean;
  const double normal = at_radius(problem.normal, c), tangential = at_radius(problem.tangential, c);
  const double normal_ratio = modulus_ratio(body, angular_frequency(control.normal_frequency));
  const double tangential_ratio = modulus_ratio(body, angular_frequency(control.tangential_frequency));
  const Motion motion{indentation,
                      normal / normal_ratio,
                      1.5 * mu * tangential / tangential_ratio,
                      control.normal_frequency,
                      control.tangential_frequency,
                      problem.phase};
  const double stiffness = 8 * problem.relaxed_modulus * c;
  return {c, motion, stiffness * (indentation - depth) + 8 * problem.relaxed_modulus * load, stiffness * normal,
          stiffness * mu * tangential};
}

}  // namespace

void validate(double mu, const FrettingControl& control) {
  require_positive("coefficient of friction", mu);
  require_positive("normal frequency", control.normal_frequency);
  require_positive("tangential frequency", control.tangential_frequency);
  std::visit(
      [](const auto& normal) {
        require_positive("mean of the normal control", normal.mean);
        require_non_negative("amplitude of the normal control", normal.amplitude);
      },
      control.normal);
  std::visit(
      [](const auto& tangential) { require_non_negative("amplitude of the tangential control", tangential.amplitude); },
      control.tangential);
  if (!control.phase) return;
  require_finite("phase", *control.phase);
  if (control.normal_frequency != control.tangential_frequency) {
    throw std::invalid_argument(
        "the limiting state for a locked phase between unequal frequencies is not known; use equal frequencies or an "
        "unlocked phase");
  }
}

std::optional<LimitingState> limiting_state(const Profile& profile, const Rheology& body, double mu,
                                            const FrettingControl& control, StickCriterion criterion) {
  validate(mu, control);
  const Problem problem = problem_of(profile, body, mu, control, criterion);
  const auto c = problem.force_controlled ? radius_under_normal_force(problem) : radius_under_indentation(problem);
  if (!c) return std::nullopt;
  return state_at(problem, body, mu, control, *c);
}

}  // namespace fretval::mdr
