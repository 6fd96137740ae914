#include "comparison/case/oscillations.h"

namespace fretval {

std::vector<Case::Harmonic> oscillations_of(const Case::Motion& motion) {
  if (motion.path) return {};
  const double normal = motion.normal_force ? motion.normal_force->amplitude : motion.normal_amplitude,
               tangential = motion.tangential_force.value_or(motion.tangential_amplitude);
  std::vector<Case::Harmonic> all{{normal, motion.normal_frequency, 0},
                                  {tangential, motion.tangential_frequency, motion.phase.value_or(0)}};
  for (const auto* harmonics : {&motion.normal_harmonics, &motion.tangential_harmonics, &motion.transverse})
    all.insert(all.end(), harmonics->begin(), harmonics->end());
  return all;
}

std::vector<double> moving_frequencies(const Case::Motion& motion) {
  if (motion.path) return motion.path->repeats ? std::vector{1 / motion.path->duration()} : std::vector<double>{};
  std::vector<double> frequencies;
  for (const auto& [amplitude, frequency, phase] : oscillations_of(motion))
    if (amplitude != 0) frequencies.push_back(frequency);
  return frequencies;
}

}  // namespace fretval
