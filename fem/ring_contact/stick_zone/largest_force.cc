#include "fem/ring_contact/stick_zone/largest_force.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fem/motion/running_minimum.h"

namespace fretval::fem {
namespace {

Eigen::RowVector<double, 5> powers_of(double x) {
  return {1, x, x * x, x * x * x, x * x * x * x};
}

/// Place of the largest value of a quartic on [-1, 1]: between the neighbours of its largest value on a grid, where its
/// slope is zero once.
double place_of_largest(const Eigen::Vector<double, 5>& c) {
  constexpr int n_grid = 20, enough_halvings = 40;
  double at = 0;
  for (int i = -n_grid; i <= n_grid; ++i)
    if (const double x = static_cast<double>(i) / n_grid; powers_of(x) * c > powers_of(at) * c) at = x;
  double before = std::max(at - 1.0 / n_grid, -1.0), after = std::min(at + 1.0 / n_grid, 1.0);
  for (int k = 0; k < enough_halvings; ++k) {
    const double x = (before + after) / 2, slope = c[1] + x * (2 * c[2] + x * (3 * c[3] + x * 4 * c[4]));
    (slope > 0 ? before : after) = x;
  }
  return (before + after) / 2;
}

/// Peak of the quartic fitted to the largest sample and those within `half` of it.
LargestForce peak_of_quartic(const Eigen::VectorXd& samples, const Eigen::VectorXd& uncertainties, Eigen::Index half) {
  const Eigen::Index n = samples.size(), n_fitted = 2 * half + 1;
  Eigen::Index largest = 0;
  samples.maxCoeff(&largest);
  Eigen::MatrixXd powers(n_fitted, 5);
  Eigen::VectorXd fitted(n_fitted), uncertainty(n_fitted);
  for (Eigen::Index k = 0; k < n_fitted; ++k) {
    const Eigen::Index instant = (largest + k - half + n) % n;
    powers.row(k) = powers_of(static_cast<double>(k - half) / static_cast<double>(half));
    fitted[k] = samples[instant];
    uncertainty[k] = uncertainties[instant];
  }
  const Eigen::MatrixXd fit = powers.completeOrthogonalDecomposition().pseudoInverse();
  const Eigen::Vector<double, 5> coefficients = fit * fitted;
  const double at = place_of_largest(coefficients), value = powers_of(at) * coefficients;
  return {value, (powers_of(at) * fit).cwiseAbs() * uncertainty};
}

/// It lies between samples: the peak of a quartic fitted to those within a twentieth of an oscillation of the largest
/// one, two on either side of it at least. Where the contact closes within a few steps the samples scatter, which one
/// more on either side tells.
LargestForce periodic_peak(const Eigen::VectorXd& samples, const Eigen::VectorXd& uncertainties, int oscillations) {
  constexpr double safety = 2;
  const Eigen::Index half = std::max<Eigen::Index>(2, samples.size() / (60 * oscillations));
  auto peak = peak_of_quartic(samples, uncertainties, half);
  peak.uncertainty += safety * std::abs(peak_of_quartic(samples, uncertainties, half + 1).value - peak.value);
  return peak;
}

/// Along a path the largest force lies at the end of a piece, or at a sample to second order.
LargestForce peak_of_path(const Eigen::VectorXd& samples, const Eigen::VectorXd& uncertainties,
                          const std::vector<StepInPiece>& pieces) {
  RunningMinimum least(1, -std::numeric_limits<double>::infinity());
  for (Eigen::Index k = 0; k < samples.size(); ++k)
    least.add(Eigen::VectorXd::Constant(1, -samples[k]), pieces[static_cast<std::size_t>(k)]);
  Eigen::Index largest = 0;
  samples.maxCoeff(&largest);
  return {-least.value()[0], uncertainties[largest]};
}

}  // namespace

LargestForce largest_force(const NormalHistory& history, int oscillations, Flank flank) {
  const int n_steps = history.steps_per_cycle;
  Eigen::VectorXd force = history.force.tail(n_steps), uncertainty = history.force_uncertainty.tail(n_steps);
  if (flank == Flank::none) {
    force += history.force_beyond.tail(n_steps);
    uncertainty += history.force_beyond_uncertainty.tail(n_steps);
  }
  return history.pieces.empty() ? periodic_peak(force, uncertainty, oscillations)
                                : peak_of_path(force, uncertainty, history.pieces);
}

}  // namespace fretval::fem
