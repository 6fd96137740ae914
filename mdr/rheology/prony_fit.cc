#include "mdr/rheology/prony_fit.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "mdr/support/checks.h"
#include "mdr/support/constants.h"
#include "mdr/support/non_negative_least_squares.h"

namespace fretval::mdr {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int n_folds = 5;
constexpr int most_branches_per_decade = 32;
constexpr double worth_more_branches = 0.95;  // of the held-out misfit with half as many

// Rows 2j and 2j + 1 are G' and G'' at frequency j over their measured values, so the right-hand side is all ones.
// Columns are G0, the branches, and the viscosity if there is a dashpot.
MatrixXd relative_responses(const ModulusTable& table, const std::vector<double>& times, bool dashpot) {
  const Index n = static_cast<Index>(table.frequency.size()), n_branches = static_cast<Index>(times.size());
  MatrixXd responses = MatrixXd::Zero(2 * n, 1 + n_branches + dashpot);
  for (Index j = 0; j < n; ++j) {
    const std::size_t row = static_cast<std::size_t>(j);
    const double omega = 2 * pi * table.frequency[row];
    responses(2 * j, 0) = 1 / table.storage[row];
    for (Index i = 0; i < n_branches; ++i) {
      const double x = omega * times[static_cast<std::size_t>(i)];
      responses(2 * j, 1 + i) = x / (x + 1 / x) / table.storage[row];
      responses(2 * j + 1, 1 + i) = 1 / (x + 1 / x) / table.loss[row];
    }
    if (dashpot) responses(2 * j + 1, 1 + n_branches) = omega / table.loss[row];
  }
  return responses;
}

MatrixXd storage_rows(const MatrixXd& responses) {
  return Eigen::Map<const MatrixXd, 0, Eigen::Stride<Eigen::Dynamic, 2>>(responses.data(), responses.rows() / 2,
                                                                         responses.cols(), {responses.rows(), 2});
}

std::vector<double> branch_times(const ModulusTable& table, int per_decade) {
  const double shortest = 1 / (2 * pi * table.frequency.back());
  const double decades = std::log10(table.frequency.back() / table.frequency.front());
  const int n_steps = std::max(1, static_cast<int>(std::ceil(decades * per_decade)));
  std::vector<double> times;
  for (int i = 0; i <= n_steps; ++i) times.push_back(shortest * std::pow(10, decades * i / n_steps));
  return times;
}

VectorXd misfits(const MatrixXd& responses, const VectorXd& moduli) {
  return (responses * moduli).array() - 1;
}

double root_mean_square(const VectorXd& values) {
  return std::sqrt(values.squaredNorm() / static_cast<double>(values.size()));
}

double held_out_misfit(const MatrixXd& responses) {
  const Index n = responses.rows() / 2;
  VectorXd left_out(2 * n);
  for (Index fold = 0; fold < n_folds; ++fold) {
    std::vector<Index> in, out;
    for (Index row = 0; row < 2 * n; ++row) ((row / 2) % n_folds == fold ? out : in).push_back(row);
    const MatrixXd seen = responses(in, Eigen::all);
    const VectorXd moduli = non_negative_least_squares(seen, VectorXd::Ones(seen.rows()));
    const VectorXd unseen = misfits(responses(out, Eigen::all), moduli);
    for (std::size_t k = 0; k < out.size(); ++k) left_out(out[k]) = unseen(static_cast<Index>(k));
  }
  return root_mean_square(left_out);
}

// The fewest branches that finer spacing does not much improve on.
std::vector<double> chosen_times(const ModulusTable& table, bool dashpot) {
  std::vector<double> times = branch_times(table, 1);
  double misfit = held_out_misfit(relative_responses(table, times, dashpot));
  for (int per_decade = 2; per_decade <= most_branches_per_decade; per_decade *= 2) {
    std::vector<double> finer_times = branch_times(table, per_decade);
    const double finer_misfit = held_out_misfit(relative_responses(table, finer_times, dashpot));
    if (finer_misfit > worth_more_branches * misfit) break;
    times = std::move(finer_times);
    misfit = finer_misfit;
  }
  return times;
}

std::vector<double> offered_times(const ModulusTable& table, const PronyFitOptions& options) {
  if (!options.branch_times.empty()) {
    std::set<double> times;
    for (const double time : options.branch_times) {
      require_positive("branch time", time);
      if (!times.insert(time).second) reject("branch time", time, "must be given once");
    }
    return options.branch_times;
  }
  if (!options.branches_per_decade) return chosen_times(table, options.dashpot);
  require_within("branches per decade", *options.branches_per_decade, 1, most_branches_per_decade);
  return branch_times(table, *options.branches_per_decade);
}

PronyBody body_of(const VectorXd& moduli, const std::vector<double>& times, bool dashpot) {
  if (moduli(0) == 0) {
    throw std::invalid_argument(
        "relaxed modulus of the fitted Prony body = 0: the table shows no relaxed plateau, so the body would flow; "
        "must be measured to lower frequencies");
  }
  PronyBody body{moduli(0), {}, {}, dashpot ? moduli(moduli.size() - 1) : 0};
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double modulus = moduli(1 + static_cast<Index>(i));
    if (modulus == 0) continue;
    body.branch_moduli.push_back(modulus);
    body.branch_times.push_back(times[i]);
  }
  validate(body);
  return body;
}

}  // namespace

PronyFit fit_prony(const ModulusTable& table, const PronyFitOptions& options) {
  validate(table);
  const double n = static_cast<double>(table.frequency.size());
  if (n < n_folds) reject("number of frequencies for a Prony fit", n, "must be at least 5");
  const std::vector<double> times = offered_times(table, options);
  const MatrixXd responses = relative_responses(table, times, options.dashpot);
  const MatrixXd fitted = options.storage_alone ? storage_rows(responses) : responses;
  const VectorXd moduli = non_negative_least_squares(fitted, VectorXd::Ones(fitted.rows()));
  const VectorXd misfit = misfits(responses, moduli);
  Index worst;
  misfit.cwiseAbs().maxCoeff(&worst);
  return {body_of(moduli, times, options.dashpot),
          static_cast<int>(times.size()),
          root_mean_square(misfit),
          std::abs(misfit(worst)),
          table.frequency[static_cast<std::size_t>(worst / 2)],
          held_out_misfit(responses)};
}

}  // namespace fretval::mdr
