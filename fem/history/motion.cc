#include "fem/history/motion.h"

#include <cmath>

#include "fem/support/constants.h"

namespace fretval::fem {
namespace {

// Quintic smooth step: value, slope and curvature are continuous at both ends.
ValueAndRate envelope(const Motion& motion, double t) {
  const double duration = 2 * pi * motion.n_ramp_cycles;
  if (t >= duration) return {1, 0};
  const double x = t / duration;
  return {x * x * x * (10 + x * (-15 + 6 * x)), 30 * x * x * (1 - x) * (1 - x) / duration};
}

ValueAndRate phase(const Motion& motion, double t) {
  if (motion.phase) return {*motion.phase, 0};
  const double x = t / motion.n_creep_cycles;
  return {pi / 2 * (1 - std::cos(x)), pi / 2 * std::sin(x) / motion.n_creep_cycles};
}

}  // namespace

ValueAndRate normal_motion(const Motion& motion, double t) {
  const auto e = envelope(motion, t);
  return {motion.indentation + e.value * motion.normal_amplitude * std::cos(t),
          motion.normal_amplitude * (e.rate * std::cos(t) - e.value * std::sin(t))};
}

ValueAndRate tangential_motion(const Motion& motion, double t) {
  const auto e = envelope(motion, t);
  const auto phi = phase(motion, t);
  const double argument = t + phi.value;
  return {e.value * motion.tangential_amplitude * std::cos(argument),
          motion.tangential_amplitude * (e.rate * std::cos(argument) - e.value * (1 + phi.rate) * std::sin(argument))};
}

}  // namespace fretval::fem
