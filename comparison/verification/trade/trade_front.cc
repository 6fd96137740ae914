#include "comparison/verification/trade/trade_front.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "comparison/accuracy/verdict.h"

namespace fretval {
namespace {

constexpr double same_error = 1e-6;  // histories that differ in nothing that matters differ in roundoff

/// Errors of a sweep whose remainder is not its own: what other settings leave is in all of them, so those within three
/// times the smallest one say nothing about the order. 0 for an empty list.
double floor_of(const std::vector<double>& errors) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const double error : errors)
    if (std::isfinite(error)) smallest = std::min(smallest, error);
  return std::isfinite(smallest) ? 3 * smallest : 0;
}

}  // namespace

std::vector<std::size_t> pareto_front(const std::vector<ErrorAndSeconds>& points) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (std::isfinite(points[i].error) && std::isfinite(points[i].seconds)) order.push_back(i);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::tie(points[a].seconds, points[a].error) < std::tie(points[b].seconds, points[b].error);
  });
  std::vector<std::size_t> front;
  double smallest = std::numeric_limits<double>::infinity();
  for (const std::size_t i : order) {
    if (points[i].error >= (1 - same_error) * smallest) continue;
    smallest = points[i].error;
    front.push_back(i);
  }
  return front;
}

std::optional<LogSlope> observed_rate(std::vector<double> values, std::vector<double> errors) {
  const double floor = floor_of(errors);
  const auto end = std::find_if_not(errors.begin(), errors.end(), [=](double error) { return error > floor; });
  values.resize(static_cast<std::size_t>(end - errors.begin()));
  errors.resize(values.size());
  return log_slope(values, errors, 0);
}

bool meets(const Quantities& errors, double tolerance) {
  const auto tolerances = tolerances_of(tolerance);
  return !errors.empty() && std::all_of(errors.begin(), errors.end(), [&](const auto& entry) {
    return entry.second <= tolerance_of(tolerances, entry.first);
  });
}

std::optional<std::size_t> cheapest(const std::vector<Candidate>& candidates, double tolerance) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (meets(candidates[i].errors, tolerance) && (!best || candidates[i].seconds < candidates[*best].seconds))
      best = i;
  return best;
}

}  // namespace fretval
