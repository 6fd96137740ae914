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

// Vertex of the parabola through sample k and its neighbours, of a period of samples.size() - 1 steps.
double vertex_at(const std::vector<double>& samples, std::size_t k) {
  const auto n = samples.size() - 1;
  const double before = samples[(k + n - 1) % n], here = samples[k], after = samples[k + 1];
  const double bend = before - 2 * here + after, slope = (after - before) / 2;
  return bend == 0 ? here : here - slope * slope / (2 * bend);
}

// Largest value next to sample k, which may lie between two samples.
double largest_beside(const std::vector<double>& samples, std::size_t k) {
  const auto n = samples.size() - 1;
  double largest = 0;
  for (const std::size_t i : {(k + n - 1) % n, k, (k + 1) % n}) {
    const bool is_peak = samples[i] >= samples[(i + n - 1) % n] && samples[i] >= samples[i + 1];
    largest = std::max(largest, is_peak ? vertex_at(samples, i) : samples[i]);
  }
  return largest;
}

}  // namespace

double sampled_peak(const std::vector<double>& samples, double sign) {
  return vertex_at(samples, extreme_sample(samples, sign));
}

double friction_peak(const std::vector<double>& tangential, const std::vector<double>& normal, double mu) {
  double largest = 0;
  for (const double way : {1.0, -1.0}) {
    const auto k = extreme_sample(tangential, way);
    const double limit = mu * largest_beside(normal, k);
    largest = std::max(largest, std::min(way * sampled_peak(tangential, way), std::max(way * tangential[k], limit)));
  }
  return largest;
}

}  // namespace fretval::mdr
