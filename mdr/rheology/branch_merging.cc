#include "mdr/rheology/branch_merging.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "mdr/support/checks.h"
#include "mdr/support/constants.h"
#include "mdr/support/non_negative_least_squares.h"

namespace fretval::mdr {

namespace {

using Response = std::vector<std::complex<double>>;

struct Branch {
  double modulus, time;
};

std::vector<double> frequencies_between(double lowest, double highest) {
  constexpr double per_decade = 6;
  const double decades = std::log10(highest / lowest);
  const int n = std::max(1, static_cast<int>(std::ceil(decades * per_decade)));
  std::vector<double> omega;
  for (int i = 0; i <= n; ++i) omega.push_back(2 * pi * lowest * std::pow(10, decades * i / n));
  return omega;
}

Response response_of(const Branch& branch, const std::vector<double>& omega) {
  const PronyBody alone{1, {branch.modulus}, {branch.time}};
  Response response;
  for (const double w : omega) response.push_back(complex_modulus(alone, w) - 1.0);
  return response;
}

/// A body while its branches merge, and how far it is from where it began.
struct Merging {
  std::vector<double> omega;
  Response whole, off;  ///< of the body, and by how much it has changed
  std::vector<Branch> branches;
  std::vector<Response> responses;

  [[nodiscard]] double error_with(const Response& gone, const Response& gone_too, const Response& come) const {
    double worst = 0;
    for (std::size_t k = 0; k < omega.size(); ++k)
      worst = std::max(worst, std::abs(off[k] + come[k] - gone[k] - gone_too[k]) / std::abs(whole[k]));
    return worst;
  }
  [[nodiscard]] Branch merged_at(std::size_t i) const {
    const auto& [a, b] = std::pair(branches[i], branches[i + 1]);
    const double modulus = a.modulus + b.modulus;
    return {modulus, (a.modulus * a.time + b.modulus * b.time) / modulus};
  }
  void take(std::size_t i, const std::optional<Branch>& come) {
    const std::size_t n_gone = come ? 2 : 1;
    for (std::size_t k = 0; k < omega.size(); ++k)
      for (std::size_t j = i; j < i + n_gone; ++j) off[k] -= responses[j][k];
    const auto first = static_cast<std::ptrdiff_t>(i), last = static_cast<std::ptrdiff_t>(i + n_gone);
    branches.erase(branches.begin() + first, branches.begin() + last);
    responses.erase(responses.begin() + first, responses.begin() + last);
    if (!come) return;
    branches.insert(branches.begin() + first, *come);
    responses.insert(responses.begin() + first, response_of(*come, omega));
    for (std::size_t k = 0; k < omega.size(); ++k) off[k] += responses[i][k];
  }
};

/// Hastens the slowest branches, as long as nothing in the range shows it.
void hasten(Merging& merging, double tolerance) {
  const Response nothing(merging.omega.size());
  while (!merging.branches.empty()) {
    const auto slowest =
        static_cast<std::size_t>(std::max_element(merging.branches.begin(), merging.branches.end(),
                                                  [](const Branch& a, const Branch& b) { return a.time < b.time; }) -
                                 merging.branches.begin());
    auto& branch = merging.branches[slowest];
    const Branch faster{branch.modulus, branch.time / 2};
    if (faster.time * merging.omega.front() < 1) return;
    const auto response = response_of(faster, merging.omega);
    if (merging.error_with(merging.responses[slowest], nothing, response) > tolerance) return;
    for (std::size_t k = 0; k < merging.omega.size(); ++k)
      merging.off[k] += response[k] - merging.responses[slowest][k];
    branch = faster;
    merging.responses[slowest] = response;
  }
}

void sort_by_time(Merging& merging) {
  std::vector<std::pair<Branch, Response>> both;
  for (std::size_t i = 0; i < merging.branches.size(); ++i)
    both.emplace_back(merging.branches[i], std::move(merging.responses[i]));
  std::stable_sort(both.begin(), both.end(), [](const auto& a, const auto& b) { return a.first.time < b.first.time; });
  for (std::size_t i = 0; i < both.size(); ++i)
    std::tie(merging.branches[i], merging.responses[i]) = std::move(both[i]);
}

/// The step that changes the modulus least: a pair that becomes one branch, or the fastest branch left out. Empty: no
/// step is within the tolerance.
std::optional<std::pair<std::size_t, std::optional<Branch>>> least_change(const Merging& merging, double tolerance) {
  std::optional<std::pair<std::size_t, std::optional<Branch>>> best;
  double least = tolerance;
  const Response nothing(merging.omega.size());
  if (!merging.branches.empty()) {
    const double error = merging.error_with(merging.responses[0], nothing, nothing);
    if (error <= least) {
      least = error;
      best = {0, std::nullopt};
    }
  }
  for (std::size_t i = 0; i + 1 < merging.branches.size(); ++i) {
    const auto one = merging.merged_at(i);
    const double error =
        merging.error_with(merging.responses[i], merging.responses[i + 1], response_of(one, merging.omega));
    if (error > least) continue;
    least = error;
    best = {i, one};
  }
  return best;
}

void merge_neighbours(Merging& merging, double tolerance) {
  while (const auto change = least_change(merging, tolerance)) merging.take(change->first, change->second);
}

/// Real and imaginary parts over the size of the whole.
Eigen::VectorXd parts_of(const Response& response, const Response& whole) {
  Eigen::VectorXd parts(2 * static_cast<Eigen::Index>(whole.size()));
  for (std::size_t k = 0; k < whole.size(); ++k)
    parts.segment<2>(2 * static_cast<Eigen::Index>(k)) << response[k].real() / std::abs(whole[k]),
        response[k].imag() / std::abs(whole[k]);
  return parts;
}

/// Fewer branches, of other times from the fastest to the slowest one, whose moduli are fitted to the whole in the
/// range. Empty: none are within the tolerance.
std::optional<Merging> refitted(const Merging& merging, double relaxed_modulus, double tolerance) {
  constexpr std::size_t least_times = 4;
  if (merging.branches.size() <= least_times) return std::nullopt;
  Response branches = merging.whole;
  for (auto& value : branches) value -= relaxed_modulus;
  const Eigen::VectorXd wanted = parts_of(branches, merging.whole);
  const double fastest = merging.branches.front().time, slowest = merging.branches.back().time;
  for (std::size_t n = least_times; n < merging.branches.size(); ++n) {
    Eigen::MatrixXd parts(wanted.size(), n);
    std::vector<Branch> offered;
    for (std::size_t i = 0; i < n; ++i) {
      offered.push_back(
          {1, fastest * std::pow(slowest / fastest, static_cast<double>(i) / static_cast<double>(n - 1))});
      parts.col(static_cast<Eigen::Index>(i)) = parts_of(response_of(offered.back(), merging.omega), merging.whole);
    }
    const Eigen::VectorXd moduli = non_negative_least_squares(parts, wanted);
    Merging found{merging.omega, merging.whole, branches, {}, {}};
    for (auto& value : found.off) value = -value;
    for (std::size_t i = 0; i < n; ++i) {
      const double modulus = moduli[static_cast<Eigen::Index>(i)];
      if (!(modulus > 0)) continue;
      found.branches.push_back({modulus, offered[i].time});
      found.responses.push_back(response_of(found.branches.back(), found.omega));
      for (std::size_t k = 0; k < found.omega.size(); ++k) found.off[k] += found.responses.back()[k];
    }
    const Response nothing(found.omega.size());
    if (found.error_with(nothing, nothing, nothing) <= tolerance) return found;
  }
  return std::nullopt;
}

}  // namespace

MergedBody merged(const PronyBody& body, double lowest_frequency, double highest_frequency, double tolerance) {
  validate(body);
  require_positive("lowest frequency", lowest_frequency);
  require_positive("highest frequency", highest_frequency);
  require_non_negative("tolerance of merged branches", tolerance);
  if (highest_frequency < lowest_frequency)
    reject("highest frequency", highest_frequency, "must not be below the lowest one");
  Merging merging{frequencies_between(lowest_frequency, highest_frequency), {}, {}, {}, {}};
  for (const double omega : merging.omega) merging.whole.push_back(complex_modulus(body, omega));
  merging.off.assign(merging.omega.size(), 0);
  for (std::size_t i = 0; i < body.branch_moduli.size(); ++i)
    merging.branches.push_back({body.branch_moduli[i], body.branch_times[i]});
  std::sort(merging.branches.begin(), merging.branches.end(),
            [](const Branch& a, const Branch& b) { return a.time < b.time; });
  for (const auto& branch : merging.branches) merging.responses.push_back(response_of(branch, merging.omega));
  hasten(merging, tolerance / 2);
  sort_by_time(merging);
  merge_neighbours(merging, tolerance);
  constexpr double share_of_fit = 0.9;
  if (auto fitted = refitted(merging, body.relaxed_modulus, share_of_fit * tolerance)) {
    merge_neighbours(*fitted, tolerance);
    merging = std::move(*fitted);
  }

  MergedBody result{{body.relaxed_modulus, {}, {}, body.viscosity},
                    body.branch_moduli.size() - merging.branches.size(),
                    merging.error_with(Response(merging.omega.size()), Response(merging.omega.size()),
                                       Response(merging.omega.size()))};
  for (const auto& [modulus, time] : merging.branches) {
    result.body.branch_moduli.push_back(modulus);
    result.body.branch_times.push_back(time);
  }
  return result;
}

}  // namespace fretval::mdr
