#include "mdr/stick/element_forces.h"

#include <cmath>
#include <complex>
#include <stdexcept>

#include "mdr/support/checks.h"

namespace fretval::mdr {

namespace {

double oscillating_modulus(const Rheology& body, double frequency, double time, double phase) {
  require_finite("time", time);
  const double omega = angular_frequency(frequency);
  const std::complex<double> modulus = complex_modulus(body, omega);
  const double angle = omega * time + phase;
  return modulus.real() * std::cos(angle) - modulus.imag() * std::sin(angle);
}

void require_phase(const Motion& motion) {
  if (!motion.phase) throw std::invalid_argument("phase is unlocked: the tangential motion (11) needs one");
}

}  // namespace

ElementDisplacement element_displacement(const Motion& motion, double depth, double time) {
  validate(motion);
  require_phase(motion);
  require_finite("depth of the one-dimensional profile", depth);
  require_finite("time", time);
  return {
      motion.indentation - depth +
          motion.normal_amplitude * std::cos(angular_frequency(motion.normal_frequency) * time),
      motion.tangential_amplitude * std::cos(angular_frequency(motion.tangential_frequency) * time + *motion.phase)};
}

double element_normal_force(const Rheology& body, const Motion& motion, double depth, double time) {
  validate(motion);
  require_finite("depth of the one-dimensional profile", depth);
  return 4 * relaxed_modulus(body) * (motion.indentation - depth) +
         4 * motion.normal_amplitude * oscillating_modulus(body, motion.normal_frequency, time, 0);
}

double element_tangential_force(const Rheology& body, const Motion& motion, double time) {
  validate(motion);
  require_phase(motion);
  return 8.0 / 3 * motion.tangential_amplitude *
         oscillating_modulus(body, motion.tangential_frequency, time, *motion.phase);
}

double element_friction_margin(const Rheology& body, double mu, const Motion& motion, double depth, double time) {
  require_positive("coefficient of friction", mu);
  return mu * element_normal_force(body, motion, depth, time) - std::abs(element_tangential_force(body, motion, time));
}

}  // namespace fretval::mdr
