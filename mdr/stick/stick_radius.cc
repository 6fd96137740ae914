#include "mdr/stick/stick_radius.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include "mdr/stick/stick_demands.h"
#include "mdr/support/checks.h"

namespace fretval::mdr {

namespace {

StickDepths depths_of(double indentation, const StickDemands& demands) {
  return {indentation - first_slip_demand(demands), indentation - shakedown_demand(demands)};
}

// Oscillating part of the element's force under a motion, times factor/G0.
std::vector<Harmonic> response(const Rheology& body, const std::vector<Harmonic>& motion, double factor) {
  std::vector<Harmonic> forces;
  for (const Harmonic& harmonic : motion) {
    const std::complex<double> modulus = complex_modulus_ratio(body, angular_frequency(harmonic.frequency));
    forces.push_back(
        {factor * harmonic.amplitude * std::abs(modulus), harmonic.frequency, harmonic.phase + std::arg(modulus)});
  }
  return forces;
}

std::vector<Harmonic> reversed(std::vector<Harmonic> harmonics) {
  for (Harmonic& harmonic : harmonics) harmonic.amplitude = -harmonic.amplitude;
  return harmonics;
}

double supremum_of_sum(std::vector<Harmonic> first, const std::vector<Harmonic>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return supremum(first);
}

StickRadii at_most(double largest, StickRadii radii) {
  for (auto* radius : {&radii.first_slip, &radii.shakedown})
    if (*radius) *radius = std::min(**radius, largest);
  return radii;
}

}  // namespace

StickDepths stick_depths(const Rheology& body, double mu, const HarmonicMotion& motion) {
  validate(motion);
  require_positive("coefficient of friction", mu);
  const std::vector<Harmonic> pull = response(body, motion.tangential, 2 / (3 * mu));
  const std::vector<Harmonic> relief = response(body, motion.normal, -1);
  if (motion.phase_locked)
    return depths_of(motion.indentation, {supremum_of_sum(pull, relief), supremum_of_sum(reversed(pull), relief)});
  const double largest_relief = supremum(relief);
  return depths_of(motion.indentation, {supremum(pull) + largest_relief, supremum(reversed(pull)) + largest_relief});
}

StickDepths stick_depths(const Rheology& body, double mu, const Motion& motion) {
  const bool equal_frequencies = motion.normal_frequency == motion.tangential_frequency;
  if (motion.phase && !equal_frequencies) return stick_depths(body, mu, harmonic_motion(motion));
  validate(motion);
  require_positive("coefficient of friction", mu);
  const double normal_ratio = modulus_ratio(body, angular_frequency(motion.normal_frequency));
  const double tangential_ratio =
      equal_frequencies ? normal_ratio : modulus_ratio(body, angular_frequency(motion.tangential_frequency));
  const double normal = motion.normal_amplitude * normal_ratio;
  const double tangential = 2 * motion.tangential_amplitude / (3 * mu) * tangential_ratio;
  if (motion.phase) return depths_of(motion.indentation, locked_demands(tangential, normal, *motion.phase));
  return depths_of(motion.indentation, unlocked_demands(tangential, normal));
}

std::optional<double> stick_radius(const Profile& profile, double depth) {
  if (depth <= 0) return std::nullopt;
  return inverse_transform(profile, depth);
}

StickRadii stick_radii(const Profile& profile, const StickDepths& depths) {
  return {stick_radius(profile, depths.first_slip), stick_radius(profile, depths.shakedown)};
}

StickRadii stick_radii(const Profile& profile, const Rheology& body, double mu, const HarmonicMotion& motion) {
  return stick_radii(profile, stick_depths(body, mu, motion));
}

StickRadii stick_radii(const Profile& profile, const Rheology& body, double mu, const Motion& motion) {
  return stick_radii(profile, stick_depths(body, mu, motion));
}

StickRadii stick_radii(const LimitingProfile& worn, const Rheology& body, double mu, const HarmonicMotion& motion) {
  return at_most(worn.stick_radius, stick_radii(worn.unworn, body, mu, motion));
}

StickRadii stick_radii(const LimitingProfile& worn, const Rheology& body, double mu, const Motion& motion) {
  return at_most(worn.stick_radius, stick_radii(worn.unworn, body, mu, motion));
}

}  // namespace fretval::mdr
