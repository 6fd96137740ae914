#include "mdr/springs/sampled_peak.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace fretval::mdr {
namespace {

std::size_t extreme_sample(const std::vector<double>& samples, double sign) {
  std::size_t k = 0;
  for (std::size_t i = 0; i + 1 < samples.size(); ++i)
    if (sign * samples[i] > sign * samples[k]) k = i;
  return k;
}

}  // namespace

double sampled_peak(const std::vector<double>& samples, double sign) {
  const auto n = samples.size() - 1, k = extreme_sample(samples, sign);
  const double before = samples[(k + n - 1) % n], here = samples[k], after = samples[k + 1];
  const double bend = before - 2 * here + after, slope = (after - before) / 2;
  return bend == 0 ? here : here - slope * slope / (2 * bend);
}

double friction_peak(const std::vector<double>& tangential, const std::vector<double>& normal, double mu) {
  const auto n = tangential.size() - 1;
  double largest = 0;
  for (const double way : {1.0, -1.0}) {
    const auto k = extreme_sample(tangential, way);
    const double limit = mu * std::max({normal[(k + n - 1) % n], normal[k], normal[k + 1]});
    largest = std::max(largest, std::min(way * sampled_peak(tangential, way), std::max(way * tangential[k], limit)));
  }
  return largest;
}

}  // namespace fretval::mdr
