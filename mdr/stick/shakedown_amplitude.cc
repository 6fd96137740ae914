#include "mdr/stick/shakedown_amplitude.h"

#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>

#include "mdr/stick/stick_radius.h"
#include "mdr/support/checks.h"

namespace fretval::mdr {

namespace {

double amplitude_on_ellipse(double mu, double half_axis, double focus, double phase) {
  const double other_axis = std::sqrt((half_axis - focus) * (half_axis + focus));
  return 1.5 * mu / std::hypot(std::cos(phase) / half_axis, std::sin(phase) / other_axis);
}

// At the largest amplitude the tangential demand alone, less all that the normal motion can relieve, takes up the
// depth.
double amplitude_by_search(const Rheology& body, double mu, Motion motion, double depth, double largest) {
  const auto excess = [&](double amplitude) {
    motion.tangential_amplitude = amplitude;
    return stick_depths(body, mu, motion).shakedown - depth;
  };
  if (excess(0) <= 0) return 0;
  if (excess(largest) >= 0) return largest;
  std::uintmax_t iterations = 200;
  const auto bracket = boost::math::tools::toms748_solve(excess, 0.0, largest,
                                                         boost::math::tools::eps_tolerance<double>(52), iterations);
  return (bracket.first + bracket.second) / 2;
}

}  // namespace

std::optional<double> tangential_amplitude_for_shakedown(const Rheology& body, double mu, const Motion& motion,
                                                         double depth) {
  validate(motion);
  require_positive("coefficient of friction", mu);
  require_finite("depth of the one-dimensional profile", depth);
  const double normal_ratio = modulus_ratio(body, angular_frequency(motion.normal_frequency));
  const double tangential_ratio = modulus_ratio(body, angular_frequency(motion.tangential_frequency));
  const double available = motion.indentation - depth, normal = normal_ratio * motion.normal_amplitude;
  if (!(available > normal)) return std::nullopt;
  if (!motion.phase) return 1.5 * mu * (available - normal) / tangential_ratio;
  if (motion.normal_frequency == motion.tangential_frequency)
    return amplitude_on_ellipse(mu, available / normal_ratio, motion.normal_amplitude, *motion.phase);
  return amplitude_by_search(body, mu, motion, depth, 1.5 * mu * (available + normal) / tangential_ratio);
}

}  // namespace fretval::mdr
