#include "mdr/shakedown_amplitude.h"

#include <cmath>
#include <stdexcept>

#include "mdr/checks.h"

namespace fretval::mdr {

std::optional<double> tangential_amplitude_for_shakedown(const Rheology& body, double mu, const Motion& motion,
                                                         double depth) {
  validate(motion);
  require_positive("coefficient of friction", mu);
  if (motion.normal_frequency != motion.tangential_frequency)
    throw std::invalid_argument("the amplitude for a shakedown depth is known for equal frequencies only");
  const double half_axis =
      (motion.indentation - depth) / modulus_ratio(body, angular_frequency(motion.normal_frequency));
  const double focus = motion.normal_amplitude;
  if (!(half_axis > focus)) return std::nullopt;
  if (!motion.phase) return 1.5 * mu * (half_axis - focus);
  const double other_axis = std::sqrt((half_axis - focus) * (half_axis + focus));
  return 1.5 * mu / std::hypot(std::cos(*motion.phase) / half_axis, std::sin(*motion.phase) / other_axis);
}

}  // namespace fretval::mdr
