#include "fem/motion/sampled_path.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "fem/support/constants.h"

namespace fretval::fem {
namespace {

constexpr double roundoff_of_share = 1e-12;

/// Steps of a cycle at the coarsest, shared out to the pieces in proportion to their durations, with at least one in
/// each.
constexpr int coarsest = 9;

std::vector<int> coarsest_steps(const SampledPath& path) {
  std::vector<int> steps;
  for (std::size_t k = 0; k < path.n_pieces(); ++k) {
    const double share = (path.time[k + 1] - path.time[k]) / (2 * pi);
    steps.push_back(std::max(1, static_cast<int>(std::ceil(coarsest * share * (1 - roundoff_of_share)))));
  }
  return steps;
}

}  // namespace

ValueAndRate along(const SampledPath& path, const std::vector<double>& values, double t, double inside) {
  const auto next = std::upper_bound(path.time.begin() + 1, path.time.end() - 1, inside);
  const auto k = static_cast<std::size_t>(next - path.time.begin());
  const double rate = (values[k] - values[k - 1]) / (path.time[k] - path.time[k - 1]);
  // Interpolates from the nearer row, so that rows are met to all digits.
  const bool from_end = t - path.time[k - 1] > path.time[k] - t;
  return {from_end ? values[k] - rate * (path.time[k] - t) : values[k - 1] + rate * (t - path.time[k - 1]), rate};
}

int steps_along(const SampledPath& path, int wanted) {
  const auto steps = coarsest_steps(path);
  return std::max(1, static_cast<int>(std::lround(1.0 * wanted / coarsest))) *
         std::accumulate(steps.begin(), steps.end(), 0);
}

std::vector<StepInPiece> steps_of(const SampledPath& path, int n_steps) {
  const auto coarse = coarsest_steps(path);
  const int finer = n_steps / std::accumulate(coarse.begin(), coarse.end(), 0);
  std::vector<StepInPiece> steps;
  for (std::size_t k = 0; k < path.n_pieces(); ++k) {
    const int n = finer * coarse[k];
    const double first = path.time[k], last = path.time[k + 1];
    const auto instant = [&](int j) { return j == n ? last : first + (last - first) * j / n; };
    for (int j = 0; j < n; ++j) steps.push_back({instant(j), instant(j + 1), j == 0, j + 1 == n});
  }
  return steps;
}

}  // namespace fretval::fem
