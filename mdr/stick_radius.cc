#include "mdr/stick_radius.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "mdr/checks.h"

namespace fretval::mdr {

namespace {

// Largest excess of the tangential demand over the normal oscillation, for pulls in the two directions; in m.
struct Demands {
  double forward;   // M+
  double backward;  // M-
};

Demands unlocked_demands(double tangential, double normal) {
  return {tangential + normal, tangential + normal};
}

// |A e^(i phi) -+ D| as hypot(A - D, 2 sqrt(A D) sin or cos(phi/2)): free of cancellation at phi = 0, pi and A = D.
Demands locked_demands(double tangential, double normal, double phase) {
  const double cross = 2 * std::sqrt(tangential) * std::sqrt(normal);
  return {std::hypot(tangential - normal, cross * std::sin(phase / 2)),
          std::hypot(tangential - normal, cross * std::cos(phase / 2))};
}

void reject_unequal_frequencies(const Motion& motion) {
  std::ostringstream message;
  message << "phase = " << *motion.phase << " rad is locked, but the normal frequency = " << motion.normal_frequency
          << " Hz and the tangential frequency = " << motion.tangential_frequency
          << " Hz differ: this is not covered; use equal frequencies or an unlocked phase";
  throw std::invalid_argument(message.str());
}

std::optional<double> stick_radius(const Profile& profile, double depth) {
  if (depth <= 0) return std::nullopt;
  return inverse_transform(profile, depth);
}

}  // namespace

StickDepths stick_depths(const Rheology& body, double mu, const Motion& motion) {
  validate(motion);
  require_positive("coefficient of friction", mu);
  if (motion.phase && motion.normal_frequency != motion.tangential_frequency) reject_unequal_frequencies(motion);

  const double normal = motion.normal_amplitude * modulus_ratio(body, angular_frequency(motion.normal_frequency));
  const double tangential =
      2 * motion.tangential_amplitude / (3 * mu) * modulus_ratio(body, angular_frequency(motion.tangential_frequency));
  const Demands demands =
      motion.phase ? locked_demands(tangential, normal, *motion.phase) : unlocked_demands(tangential, normal);
  return {motion.indentation - std::max(demands.forward, demands.backward),
          motion.indentation - (demands.forward + demands.backward) / 2};
}

StickRadii stick_radii(const Profile& profile, const Rheology& body, double mu, const Motion& motion) {
  const StickDepths depths = stick_depths(body, mu, motion);
  return {stick_radius(profile, depths.first_slip), stick_radius(profile, depths.shakedown)};
}

}  // namespace fretval::mdr
