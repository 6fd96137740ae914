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

double width_of_ring_at(const Compliance& compliance, double radius) {
  const auto& radii = compliance.radii;
  const auto outer = std::lower_bound(radii.begin() + 1, radii.end() - 1, radius);
  return *outer - *(outer - 1);
}

/// Where the edge of the contact of a body with memory travels by hardly a ring in a cycle, the rings do not show the
/// pressures between its ends. Up to 2 % of the amplitude of the force were missed (cone, |G| of 15 G0, at 0.2 rings).
double unseen_travel(const ContactProblem& problem, const ForceContext& context, const NormalHistory& history) {
  constexpr double few_rings = 2, share = 0.05;
  constexpr int order = 6;
  if (!context.relaxation.has_memory() || context.worn) return 0;
  const auto radius = history.contact_radius.tail(history.steps_per_cycle);
  const auto force = history.force.tail(history.steps_per_cycle);
  const double n_rings =
      (radius.maxCoeff() - radius.minCoeff()) / width_of_ring_at(problem.compliance, radius.maxCoeff());
  const double unseen = share * std::pow(few_rings / std::max(n_rings, few_rings), order);
  return unseen * (force.maxCoeff() - force.minCoeff()) / 2;
}

/// Where the contact grows by more than a ring in a step at its largest force, each of these rings has the pressure of
/// the whole step. Of the share that a ring has in the force, 13 % were missed (a branch of 1.5 steps, contact lost in
/// every cycle), by chance nothing with other steps.
double unseen_growth(const ContactProblem& problem, const ForceContext& context, const NormalHistory& history) {
  constexpr double share = 0.2;
  if (!context.relaxation.has_memory() || context.worn) return 0;
  const auto radius = history.contact_radius.tail(history.steps_per_cycle);
  const auto force = history.force.tail(history.steps_per_cycle);
  Eigen::Index peak = 0;
  const double largest = force.maxCoeff(&peak);
  const Eigen::Index before = (peak + history.steps_per_cycle - 1) % history.steps_per_cycle;
  const double ring = width_of_ring_at(problem.compliance, radius[peak]);
  return radius[peak] - radius[before] > ring ? share * 2 * ring / radius[peak] * largest : 0;
}

/// A contact that ends hardly beyond the sharp edge of its indenter is a flat punch to its last rings, whose force is
/// that of a disc up to half a ring larger or smaller (0.17 rings measured, at 0.2 rings beyond the edge).
double force_at_sharp_edge(const Compliance& compliance, const ForceContext& context, const NormalHistory& history) {
  constexpr double few_rings = 2, share_of_ring = 0.5;
  const double radius = history.contact_radius.tail(history.steps_per_cycle).maxCoeff();
  const double ring = width_of_ring_at(compliance, radius);
  if (!context.sharp_edge || radius - *context.sharp_edge > few_rings * ring) return 0;
  return share_of_ring * ring / radius * history.force.tail(history.steps_per_cycle).maxCoeff();
}

}  // namespace

LargestForce largest_force(const ContactProblem& problem, const ForceContext& context, const NormalHistory& history) {
  const int n_steps = history.steps_per_cycle;
  Eigen::VectorXd force = history.force.tail(n_steps), uncertainty = history.force_uncertainty.tail(n_steps);
  if (!context.worn) {
    force += history.force_beyond.tail(n_steps);
    uncertainty += history.force_beyond_uncertainty.tail(n_steps);
  }
  auto largest = history.pieces.empty() ? periodic_peak(force, uncertainty, context.oscillations)
                                        : peak_of_path(force, uncertainty, history.pieces);
  largest.uncertainty += unseen_travel(problem, context, history) + unseen_growth(problem, context, history) +
                         force_at_sharp_edge(problem.compliance, context, history);
  return largest;
}

}  // namespace fretval::fem
