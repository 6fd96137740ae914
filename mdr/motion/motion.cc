#include "mdr/motion/motion.h"

#include "mdr/support/checks.h"
#include "mdr/support/constants.h"

namespace fretval::mdr {

void validate(const Motion& motion) {
  require_positive("indentation", motion.indentation);
  require_non_negative("normal amplitude", motion.normal_amplitude);
  require_non_negative("tangential amplitude", motion.tangential_amplitude);
  require_positive("normal frequency", motion.normal_frequency);
  require_positive("tangential frequency", motion.tangential_frequency);
  if (motion.phase) require_finite("phase", *motion.phase);
}

double maximum_indentation(const Motion& motion) {
  return motion.indentation + motion.normal_amplitude;
}

double angular_frequency(double frequency) {
  return 2 * pi * frequency;
}

}  // namespace fretval::mdr
