#include "mdr/springs/sampled_peak.h"

#include <cstddef>

namespace fretval::mdr {

double sampled_peak(const std::vector<double>& samples, double sign) {
  const auto n = samples.size() - 1;
  std::size_t k = 0;
  for (std::size_t i = 0; i < n; ++i)
    if (sign * samples[i] > sign * samples[k]) k = i;
  const double before = samples[(k + n - 1) % n], here = samples[k], after = samples[k + 1];
  const double bend = before - 2 * here + after, slope = (after - before) / 2;
  return bend == 0 ? here : here - slope * slope / (2 * bend);
}

}  // namespace fretval::mdr
