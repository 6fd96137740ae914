#include "fem/motion/running_minimum.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fretval::fem {
namespace {

/// Five samples at -2, ..., 2 by their central differences (Stirling): f0 + x s + x^2/2 c + x (x^2 - 1)/6 t +
/// x^2 (x^2 - 1)/24 q. The middle one is the smallest of the inner three.
struct Differences {
  double f0, s, c, t, q;

  Differences(double a, double b, double f, double d, double e)
      : f0(f), s((d - b) / 2), c(d - 2 * f + b), t((e - 2 * d + 2 * b - a) / 2), q(e - 4 * d + 6 * f - 4 * b + a) {}

  [[nodiscard]] bool smooth() const { return std::abs(t) < c / 2 && std::abs(q) < c / 2; }
  [[nodiscard]] double vertex_of_parabola() const { return c > 0 ? f0 - s * s / (2 * c) : f0; }

  [[nodiscard]] double minimum_of_quartic() const {
    constexpr int enough_iterations = 4;
    double x = -s / c;
    for (int k = 0; k < enough_iterations; ++k) {
      const double slope = s + x * c + (3 * x * x - 1) / 6 * t + x * (2 * x * x - 1) / 12 * q;
      x = std::clamp(x - slope / (c + x * t + (6 * x * x - 1) / 12 * q), -1.0, 1.0);
    }
    const double rest = x * x - 1;
    return f0 + x * s + x * x / 2 * c + x * rest / 6 * t + x * x * rest / 24 * q;
  }
};

}  // namespace

RunningMinimum::RunningMinimum(Eigen::Index n, double floor)
    : minimum_(Eigen::VectorXd::Constant(n, std::numeric_limits<double>::infinity())), floor_(floor) {
  samples_.fill(Eigen::VectorXd(n));
}

/// To the ends of a piece, from samples at the same fraction of equal steps.
void RunningMinimum::extend_to_ends(const StepInPiece& step) {
  const auto &before = samples_[samples_.size() - 2], &last = samples_.back();
  const auto see = [this](const Eigen::VectorXd& end) { minimum_ = minimum_.cwiseMin(end.cwiseMax(floor_)); };
  if (!step.first && second_of_piece_) see(before - step.fraction * (last - before));
  if (!step.first && step.last) see(last + (1 - step.fraction) * (last - before));
  second_of_piece_ = step.first;
}

void RunningMinimum::see_last(const std::optional<StepInPiece>& step) {
  minimum_ = minimum_.cwiseMin(samples_.back());
  if (step) return extend_to_ends(*step);
  if (++n_samples_ < static_cast<int>(samples_.size())) return;
  const auto& [a, b, middle, d, e] = samples_;
  for (Eigen::Index i = 0; i < middle.size(); ++i) {
    // Smooth samples have no minimum lower than a fifth of their second difference below the middle one, and a parabola
    // none lower than an eighth.
    const double lowest = middle[i] - (d[i] - 2 * middle[i] + b[i]) / 5;
    if (lowest >= minimum_[i] || middle[i] > std::min(b[i], d[i])) continue;
    const Differences differences(a[i], b[i], middle[i], d[i], e[i]);
    const double smallest = differences.smooth() ? differences.minimum_of_quartic() : differences.vertex_of_parabola();
    minimum_[i] = std::min(minimum_[i], std::max(smallest, floor_));
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

}  // namespace fretval::fem
