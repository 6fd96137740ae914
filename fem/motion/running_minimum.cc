#include "fem/motion/running_minimum.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fem/motion/sampled_minimum.h"
#include "fem/support/wide_registers.h"

namespace fretval::fem {
namespace {

/// Whether the middle one of three samples may have a minimum beside it that is lower than what is known. Smooth
/// samples have none lower than their parabola by 0.0375 of its second difference c: between samples third differences
/// below c/2 add at most c/2 / (9 sqrt(3)), fourth ones c/2 / 96. Without a branch.
bool may_be_lower(double b, double middle, double d, double least) {
  const double slope = (d - b) / 2, second = d - 2 * middle + b;
  return (middle <= b) & (middle <= d) & (second * (middle - least) < slope * slope / 2 + 0.0375 * second * second);
}

}  // namespace

RunningMinimum::RunningMinimum(Eigen::Index n, double floor)
    : minimum_(Eigen::VectorXd::Constant(n, std::numeric_limits<double>::infinity())),
      samples_(n, n_kept),
      floor_(floor) {}

/// Extends signals to the ends of a piece of a path, linearly from samples that are taken at the same fraction of equal
/// steps.
void RunningMinimum::extend_to_ends(const StepInPiece& step) {
  const auto before = sample(1), last = sample(0);
  const auto see = [this](const auto& end) { minimum_ = minimum_.cwiseMin(end.cwiseMax(floor_)); };
  if (!step.first && second_of_piece_) see(before - step.fraction * (last - before));
  if (!step.first && step.last) see(last + (1 - step.fraction) * (last - before));
  second_of_piece_ = step.first;
}

void RunningMinimum::see_last(const std::optional<StepInPiece>& step) {
  if (step || ++n_samples_ < n_kept) {
    minimum_ = minimum_.cwiseMin(sample(0));
    if (step) extend_to_ends(*step);
    return;
  }
  const double *a = sample(4).data(), *b = sample(3).data(), *middle = sample(2).data(), *d = sample(1).data(),
               *e = sample(0).data();
  double* least = minimum_.data();
  const Eigen::Index n = minimum_.size();
  Eigen::Index n_minima = 0;
  in_wide_registers([&](auto) {
    Eigen::Index n_found = 0;
#pragma GCC ivdep
    for (Eigen::Index i = 0; i < n; ++i) {
      least[i] = std::min(least[i], e[i]);
      n_found += may_be_lower(b[i], middle[i], d[i], least[i]);
    }
    n_minima = n_found;
  });
  for (Eigen::Index i = 0; n_minima > 0; ++i) {
    if (!may_be_lower(b[i], middle[i], d[i], least[i])) continue;
    --n_minima;
    const SampledMinimum sampled(a[i], b[i], middle[i], d[i], e[i]);
    const double smallest = sampled.smooth() ? sampled.minimum_of_quartic() : sampled.vertex_of_parabola();
    least[i] = std::min(least[i], std::max(smallest, floor_));
  }
}

void RunningMinimum::restart() {
  minimum_.setConstant(std::numeric_limits<double>::infinity());
}

double largest_of_period(const Eigen::VectorXd& samples, const std::vector<StepInPiece>& pieces) {
  RunningMinimum least(1, -std::numeric_limits<double>::infinity());
  const auto add = [&](Eigen::Index k, const std::optional<StepInPiece>& step) {
    least.add(Eigen::VectorXd::Constant(1, -samples[k]), step);
  };
  if (pieces.empty())
    for (Eigen::Index k = 0; k < 2 * samples.size(); ++k) add(k % samples.size(), std::nullopt);
  else
    for (Eigen::Index k = 0; k < samples.size(); ++k) add(k, pieces[static_cast<std::size_t>(k)]);
  return -least.value()[0];
}

double largest_magnitude_of_period(const Eigen::VectorXd& samples, const std::vector<StepInPiece>& pieces) {
  return std::max(largest_of_period(samples, pieces), largest_of_period(-samples, pieces));
}

}  // namespace fretval::fem
