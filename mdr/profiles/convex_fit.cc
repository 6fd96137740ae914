#include "mdr/profiles/convex_fit.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <stdexcept>

#include "mdr/profiles/profile_rows.h"
#include "mdr/support/checks.h"
#include "mdr/support/non_negative_least_squares.h"

namespace fretval::mdr {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr std::size_t n_least_fitted_rows = 8, n_most_rows = 100'000, n_most_knots = 200;
constexpr double largest_excess = 1.5;   // residual rms over noise
constexpr double least_noise = 1e-10;    // over the range of heights, roundoff of the fit
constexpr double least_interval = 1e-6;  // over the last radius
constexpr double hardly_pointed = 0.01;  // slope of the tip over the steepest one
constexpr double spare_deviations = 2;   // beyond the largest that is expected in a table

struct Solution {
  double offset, tip_slope;
  VectorXd curvature;  // f'' at the knots
  VectorXd residual;   // row less fit
};

// A stretch of rows with the sum of its residuals in standard deviations of that sum.
struct Run {
  Index first, size;
  double deviations;
};

// Hat j of f'' integrated twice from the axis: a cubic in its two intervals, beyond them a line through its centroid.
double integrated_hat(const std::vector<double>& knots, std::size_t j, double r) {
  const double left = j > 0 ? knots[j - 1] : knots[j], right = j + 1 < knots.size() ? knots[j + 1] : knots[j];
  const double middle = knots[j];
  if (r <= left) return 0;
  if (r <= middle) return std::pow(r - left, 3) / (6 * (middle - left));
  const double line = (right - left) / 2 * (r - (left + middle + right) / 3);
  return r < right ? line + std::pow(right - r, 3) / (6 * (right - middle)) : line;
}

Solution fit_on(const std::vector<double>& knots, const VectorXd& r, const VectorXd& f, bool pointed) {
  const auto n_knots = static_cast<Index>(knots.size());
  MatrixXd columns(r.size(), n_knots + (pointed ? 1 : 0));
  for (Index j = 0; j < n_knots; ++j)
    columns.col(j) = r.unaryExpr([&](double x) { return integrated_hat(knots, static_cast<std::size_t>(j), x); });
  if (pointed) columns.col(n_knots) = r;
  // Least squares with a free offset are those of what remains after the means.
  const Eigen::RowVectorXd means = columns.colwise().mean();
  const VectorXd centred = f.array() - f.mean();
  const VectorXd x = non_negative_least_squares(columns.rowwise() - means, centred);
  const VectorXd residual = centred - (columns.rowwise() - means) * x;
  return {f.mean() - means.dot(x), pointed ? x(n_knots) : 0, x.head(n_knots), residual};
}

double rms(const VectorXd& residual) {
  return residual.norm() / std::sqrt(static_cast<double>(residual.size()));
}

// All runs of 1, 2, 4, ... rows that are one-sided beyond chance.
std::vector<Run> one_sided_runs(const VectorXd& residual, double noise) {
  const Index n = residual.size();
  // Noise stated a little too small is no reason to see runs in it.
  const double deviation = noise * std::clamp(rms(residual) / noise, 1.0, largest_excess);
  const double most = spare_deviations + std::sqrt(2 * std::log(static_cast<double>(n)));
  VectorXd sums = VectorXd::Zero(n + 1);
  for (Index k = 0; k < n; ++k) sums(k + 1) = sums(k) + residual(k);
  std::vector<Run> runs;
  for (Index size = 1; size <= n; size *= 2) {
    for (Index first = 0; first + size <= n; ++first) {
      const double sum = sums(first + size) - sums(first);
      const double deviations = sum / (deviation * std::sqrt(static_cast<double>(size)));
      if (std::abs(deviations) > most) runs.push_back({first, size, deviations});
    }
  }
  return runs;
}

// Strongest run by the interval between knots that holds its middle, or a row next to that: a kink between knots shows
// in the rows beside it.
std::vector<double> strengths(const std::vector<double>& knots, const VectorXd& r, const std::vector<Run>& runs) {
  // Residuals too large without a one-sided run have no place.
  std::vector<double> strength(knots.size() - 1, runs.empty() ? 1 : 0);
  for (const Run& run : runs) {
    const Index middle = run.first + run.size / 2;
    const Index last = std::min(middle + 2, r.size() - 1);
    for (Index row = std::max(middle - 2, Index{0}); row <= last; ++row) {
      const auto above = std::upper_bound(knots.begin() + 1, knots.end() - 1, r(row));
      double& strongest = strength[static_cast<std::size_t>(above - knots.begin()) - 1];
      strongest = std::max(strongest, std::abs(run.deviations));
    }
  }
  return strength;
}

// Knots to add between two: one in the middle of the rows, or around a single row, where the profile may have a kink.
std::vector<double> knots_between(double left, double right, const VectorXd& r) {
  if (right - left < least_interval * r(r.size() - 1)) return {};
  const double* first = std::lower_bound(r.data(), r.data() + r.size(), left);
  const double* last = std::upper_bound(first, r.data() + r.size(), right);
  if (last == first) return {};
  const double* middle = first + (last - first) / 2;
  if (last - first > 1) return {(middle[-1] + *middle) / 2};
  std::vector<double> around;
  if (*middle > left) around.push_back((left + *middle) / 2);
  if (*middle < right) around.push_back((*middle + right) / 2);
  return around;
}

// Adds knots in the intervals of the strongest runs among those that take any. False if there are none.
bool refine(std::vector<double>& knots, const VectorXd& r, const std::vector<Run>& runs) {
  const std::vector<double> strength = strengths(knots, r, runs);
  std::vector<std::vector<double>> added(strength.size());
  double strongest = 0;
  for (std::size_t k = 0; k < strength.size(); ++k) {
    added[k] = knots_between(knots[k], knots[k + 1], r);
    if (!added[k].empty()) strongest = std::max(strongest, strength[k]);
  }
  std::vector<double> finer;
  for (std::size_t k = 0; k < strength.size(); ++k) {
    finer.push_back(knots[k]);
    if (strength[k] > 0 && strength[k] >= strongest / 2) finer.insert(finer.end(), added[k].begin(), added[k].end());
  }
  finer.push_back(knots.back());
  knots = finer;
  return strongest > 0;
}

PiecewiseCubic cubic_of(const std::vector<double>& knots, const Solution& solution) {
  PiecewiseCubic height{knots, {}};
  double f = 0, slope = solution.tip_slope;
  for (std::size_t k = 0; k + 1 < knots.size(); ++k) {
    const double h = knots[k + 1] - knots[k];
    const double left = solution.curvature(static_cast<Index>(k)),
                 right = solution.curvature(static_cast<Index>(k) + 1);
    height.coefficients.push_back({f, slope, left / 2, (right - left) / (6 * h)});
    f += h * (slope + h * (2 * left + right) / 6);
    slope += h * (left + right) / 2;
  }
  return height;
}

[[noreturn]] void refuse(const VectorXd& r, const VectorXd& residual, const std::vector<Run>& runs, double noise) {
  std::ostringstream why;
  why.precision(3);
  why << "heights are not those of a convex profile within the stated noise of " << noise
      << " m: the best one leaves residuals of " << rms(residual) << " m rms";
  Index worst;
  residual.cwiseAbs().maxCoeff(&worst);
  double place = r(worst);
  if (!runs.empty()) {
    const Run& run = *std::max_element(runs.begin(), runs.end(), [](const Run& a, const Run& b) {
      return std::abs(a.deviations) < std::abs(b.deviations);
    });
    const double last = r(run.first + run.size - 1), mean = residual.segment(run.first, run.size).mean();
    place = (r(run.first) + last) / 2;
    if (run.size > 1)
      why << ", and rows from " << r(run.first) << " to " << last << " m lie on average ";
    else
      why << ", and the row here lies ";
    why << std::abs(mean) << " m " << (mean > 0 ? "above" : "below") << " it";
  }
  why << "; remove the bump or dimple, or state the noise that the heights have";
  reject("profile table at r in m", place, why.str());
}

bool acceptable(const VectorXd& residual, double noise) {
  return rms(residual) <= largest_excess * noise && one_sided_runs(residual, noise).empty();
}

double steepest_slope(const std::vector<double>& knots, const Solution& solution) {
  double slope = solution.tip_slope;
  for (std::size_t j = 1; j < knots.size(); ++j) {
    const auto right = static_cast<Index>(j);
    slope += (knots[j] - knots[j - 1]) * (solution.curvature[right - 1] + solution.curvature[right]) / 2;
  }
  return slope;
}

/// A slope at the tip that is next to nothing may stand for a bend of f'' that some more knots show.
void take_smooth_tip(const VectorXd& r, const VectorXd& f, double noise, std::vector<double>& knots, Solution& best) {
  constexpr int n_rounds = 3;
  auto finer = knots;
  for (int round = 0; round < n_rounds; ++round) {
    const Solution smooth = fit_on(finer, r, f, false);
    if (acceptable(smooth.residual, noise)) {
      knots = std::move(finer);
      best = smooth;
      return;
    }
    if (finer.size() >= n_most_knots || !refine(finer, r, one_sided_runs(smooth.residual, noise))) return;
  }
}

}  // namespace

ConvexFit convex_fit(const std::vector<double>& r, const std::vector<double>& f, double noise) {
  require_positive("noise of the profile table in m", noise);
  require_profile_rows(r, f, n_least_fitted_rows);
  if (r.size() > n_most_rows)
    reject("number of rows of a noisy profile table", static_cast<double>(r.size()),
           "must be at most 100000; average neighbouring rows");
  const VectorXd radii = VectorXd::Map(r.data(), static_cast<Index>(r.size()));
  const VectorXd heights = VectorXd::Map(f.data(), static_cast<Index>(f.size()));
  noise = std::max(noise, least_noise * (heights.maxCoeff() - heights.minCoeff()));

  std::vector<double> knots{0, r.back()};
  Solution best = fit_on(knots, radii, heights, true);
  while (!acceptable(best.residual, noise)) {
    const std::vector<Run> runs = one_sided_runs(best.residual, noise);
    if (knots.size() >= n_most_knots || !refine(knots, radii, runs)) refuse(radii, best.residual, runs, noise);
    best = fit_on(knots, radii, heights, true);
  }
  const Solution smooth = fit_on(knots, radii, heights, false);
  if (acceptable(smooth.residual, noise))
    best = smooth;
  else if (best.tip_slope < hardly_pointed * steepest_slope(knots, best))
    take_smooth_tip(radii, heights, noise, knots, best);

  Index worst;
  best.residual.cwiseAbs().maxCoeff(&worst);
  return {cubic_of(knots, best), best.offset, rms(best.residual), best.residual(worst), radii(worst)};
}

}  // namespace fretval::mdr
