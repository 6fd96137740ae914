#include "mdr/motion/harmonic_motion.h"

#include <string>

#include "mdr/support/checks.h"

namespace fretval::mdr {

namespace {

void validate_direction(const std::vector<Harmonic>& harmonics, const std::string& direction) {
  for (std::size_t i = 0; i < harmonics.size(); ++i) {
    const std::string where = " of " + direction + " harmonic " + std::to_string(i + 1);
    require_non_negative("amplitude" + where, harmonics[i].amplitude);
    require_positive("frequency" + where, harmonics[i].frequency);
    require_finite("phase" + where, harmonics[i].phase);
  }
}

}  // namespace

void validate(const HarmonicMotion& motion) {
  require_positive("indentation", motion.indentation);
  validate_direction(motion.normal, "normal");
  validate_direction(motion.tangential, "tangential");
}

HarmonicMotion harmonic_motion(const Motion& motion) {
  validate(motion);
  return {motion.indentation,
          {{motion.normal_amplitude, motion.normal_frequency, 0}},
          {{motion.tangential_amplitude, motion.tangential_frequency, motion.phase.value_or(0)}},
          motion.phase.has_value()};
}

double maximum_indentation(const HarmonicMotion& motion) {
  validate(motion);
  return motion.indentation + supremum(motion.normal);
}

double minimum_indentation(const HarmonicMotion& motion) {
  validate(motion);
  std::vector<Harmonic> reversed = motion.normal;
  for (Harmonic& harmonic : reversed) harmonic.amplitude = -harmonic.amplitude;
  return motion.indentation - supremum(reversed);
}

}  // namespace fretval::mdr
