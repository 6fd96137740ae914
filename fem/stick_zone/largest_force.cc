#include "fem/stick_zone/largest_force.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fem/motion/running_minimum.h"

namespace fretval::fem {
namespace {

/// Peak of the quartic fitted to the largest sample and those within `half` of it.
LargestForce peak_of_quartic(const Eigen::VectorXd& samples, const Eigen::VectorXd& uncertainties, Eigen::Index half) {
  const Eigen::Index n = samples.size(), n_fitted = 2 * half + 1;
  Eigen::Index largest = 0;
  samples.maxCoeff(&largest);
  const auto powers_of = [](double x) { return Eigen::RowVector<double, 5>(1, x, x * x, x * x * x, x * x * x * x); };
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
  double value = -std::numeric_limits<double>::infinity(), at = 0;
  for (int i = -500; i <= 500; ++i)
    if (const double x = i / 500.0, there = powers_of(x) * coefficients; there > value) {
      value = there;
      at = x;
    }
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
