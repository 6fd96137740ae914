#include "mdr/stick/limiting_motion.h"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <complex>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <vector>

#include "mdr/motion/force_control.h"
#include "mdr/motion/motion.h"
#include "mdr/profiles/indentation.h"
#include "mdr/stick/stick_radius.h"

namespace fretval::mdr {

namespace {

std::vector<Harmonic> displacements_of(std::vector<Harmonic> forces, const Rheology& body, double stiffness) {
  for (auto& [amplitude, frequency, phase, across] : forces) {
    const auto modulus = complex_modulus(body, angular_frequency(frequency));
    amplitude /= stiffness * std::abs(modulus);
    phase -= std::arg(modulus);
  }
  return forces;
}

// The zero of a function that is positive at the lower end and negative at the upper one.
double crossing(const std::function<double(double)>& f, double lower, double upper) {
  std::uintmax_t iterations = 200;
  const auto bracket =
      boost::math::tools::toms748_solve(f, lower, upper, boost::math::tools::eps_tolerance<double>(50), iterations);
  return (bracket.first + bracket.second) / 2;
}

// Follows wear to the limiting radius from c on: the contact shrinks to the zone that sticks, whose load rises thereby.
// Empty: in the end nothing sticks.
std::optional<double> descend(const Profile& profile, const std::function<double(double)>& sticking_depth, double c) {
  constexpr int most_steps = 100000;
  constexpr double roundoff = 1e-13;
  for (int i = 0; i < most_steps; ++i) {
    const double depth = sticking_depth(c);
    if (depth <= 0) return std::nullopt;
    const double sticking = inverse_transform(profile, depth);
    if (!(sticking < (1 - roundoff) * c)) return std::min(sticking, c);
    c = sticking;
  }
  throw std::runtime_error("the stick radius was not found: the load is within roundoff of the largest that sticks");
}

}  // namespace

std::optional<LimitingMotion> limiting_motion(const Profile& profile, const Rheology& body, double mu,
                                              const HarmonicMotion& prescribed, bool with_normal_force,
                                              bool with_tangential_force, StickCriterion criterion) {
  return limiting_motion(profile, body, prescribed, with_normal_force, with_tangential_force,
                         [&](const HarmonicMotion& motion) {
                           const auto depths = stick_depths(body, mu, motion);
                           return criterion == StickCriterion::shakedown ? depths.shakedown : depths.first_slip;
                         });
}

std::optional<LimitingMotion> limiting_motion(const Profile& profile, const Rheology& body,
                                              const HarmonicMotion& prescribed, bool with_normal_force,
                                              bool with_tangential_force,
                                              const std::function<double(const HarmonicMotion&)>& sticking_depth_of) {
  validate(prescribed);
  const double load = prescribed.indentation / (8 * relaxed_modulus(body));
  const auto unworn_load = [&profile](double c) { return normal_force(profile, 1, transform(profile, c)) / 8; };
  const auto motion_at = [&](double c) {
    auto motion = prescribed;
    if (with_normal_force) {
      motion.indentation = transform(profile, c) + (load - unworn_load(c)) / c;
      motion.normal = displacements_of(motion.normal, body, 8 * c);
    }
    if (with_tangential_force) motion.tangential = displacements_of(motion.tangential, body, 16.0 / 3 * c);
    return motion;
  };
  const auto sticking_depth = [&](double c) { return sticking_depth_of(motion_at(c)); };

  std::optional<double> stick_radius;
  if (with_normal_force) {
    // What the edge can bear falls with c, and what it needs rises: one crossing at most.
    constexpr double least = 1e-9;
    const auto surplus = [&](double c) { return c * (sticking_depth(c) - transform(profile, c)); };
    const double unworn =
        contact_radius(profile, indentation_for_force(profile, relaxed_modulus(body), prescribed.indentation));
    if (surplus(unworn) >= 0)
      stick_radius = unworn;
    else if (surplus(least * unworn) > 0)
      stick_radius = crossing(surplus, least * unworn, unworn);
  } else {
    stick_radius = descend(profile, sticking_depth, contact_radius(profile, prescribed.indentation));
  }
  if (!stick_radius) return std::nullopt;
  return LimitingMotion{*stick_radius, from_largest_indentation(motion_at(*stick_radius))};
}

}  // namespace fretval::mdr
