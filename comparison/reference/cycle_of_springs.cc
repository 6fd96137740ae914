#include "comparison/reference/cycle_of_springs.h"

#include <algorithm>

namespace fretval {
bool settles_for_long(const mdr::PronyBody& body, double period) {
  constexpr int many_periods = 100, all_periods = 2000;  // ten creep times
  const int n = mdr::periods_of_creep(body, period);
  return n > (body.viscosity > 0 ? many_periods : all_periods / 2 - 1);
}

std::optional<mdr::CommonCycle> cycle_to_step(const MdrCase& mdr) {
  const auto& harmonics = mdr.motion.tangential;
  const bool moves = std::any_of(harmonics.begin(), harmonics.end(), [](const auto& h) { return h.amplitude > 0; });
  if (mdr.limiting || !mdr.motion.phase_locked || !moves) return std::nullopt;
  const auto cycle = mdr::common_cycle(mdr.motion);
  if (!cycle || cycle->highest_order() > longest_cycle) return std::nullopt;
  return settles_for_long(mdr.body, 1 / cycle->frequency) ? std::nullopt : cycle;
}

std::optional<MdrCycle> cycle_of_springs(const MdrCase& mdr, const mdr::SteppedForcedResponse& stepped,
                                         double normal_force_max) {
  const auto cycle = cycle_to_step(mdr);
  if (!cycle) return std::nullopt;
  double sum = 0, path = 0;
  for (std::size_t k = 0; k < mdr.motion.tangential.size(); ++k) {
    sum += mdr.motion.tangential[k].amplitude;
    path += 4 * mdr.motion.tangential[k].amplitude * cycle->tangential_orders[k];
  }
  const auto& [response, error] = stepped;
  if (mdr.tangential_force) path *= response.tangential_amplitude / sum;
  return cycle_of(mdr, response, error, normal_force_max, path);
}

}  // namespace fretval
