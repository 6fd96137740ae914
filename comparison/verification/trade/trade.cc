#include "comparison/verification/trade/trade.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparison/results/case_result.h"
#include "comparison/simulation/compute_case.h"
#include "comparison/support/log.h"
#include "comparison/support/resident_memory.h"
#include "comparison/verification/trade/trade_front.h"
#include "fem/support/solver_error.h"
#include "meshes/mesh_error.h"

namespace fretval {
namespace {

void compute_point(const PreparedCase& prepared, const Quantities& reference, TradePoint& point) {
  const ResidentGrowth growth;
  try {
    BodyStore its_own;
    const auto answer = compute_case(prepared.fem, point.resolution, its_own);
    point.errors = errors_of(quantities_of(answer, prepared.fem.units), reference);
    point.seconds = answer.seconds_alone();
    point.n_normal_steps = static_cast<long>(answer.normal.n_cycles) * answer.normal.steps_per_cycle;
    point.n_friction_steps = answer.n_steps;
    point.cost = cost_json(answer);
    point.memory_bytes = growth.peak_bytes();
  } catch (const fem::SolverError& error) {
    point.failure = error.what();
  } catch (const meshes::MeshError& error) {
    point.failure = error.what();
  }
  if (!point.failure.empty()) log::warn(fmt::format("a setting failed: {}", point.failure));
}

std::vector<TradePoint> condensed_points(const PreparedCase& prepared, const TradePlan& plan,
                                         const Quantities& reference) {
  std::vector<TradePoint> points;
  // The first body of a process also pays for what its libraries load and allocate once and for all.
  make_body(at_resolution(prepared.fem, plan.settings.begin()->first).body);
  for (const auto& [resolution, sweeps] : plan.settings) {
    points.push_back({resolution, sweeps});
    compute_point(prepared, reference, points.back());
  }
  return points;
}

std::size_t index_of(const std::vector<TradePoint>& points, const Resolution& resolution) {
  const auto found =
      std::find_if(points.begin(), points.end(), [&](const TradePoint& p) { return p.resolution == resolution; });
  return static_cast<std::size_t>(found - points.begin());
}

std::vector<Recommendation> recommendations_of(const PreparedCase& prepared, const TradePlan& plan,
                                               const std::vector<TradePoint>& points) {
  std::vector<Candidate> candidates;
  for (const auto& point : points) candidates.push_back({point.errors, point.seconds});
  std::vector<Recommendation> recommendations;
  for (const double tolerance : plan.tolerances) {
    const std::size_t chosen = index_of(points, chosen_resolution(tolerance, prepared.fem));
    recommendations.push_back(
        {tolerance, cheapest(candidates, tolerance), chosen, meets(points.at(chosen).errors, tolerance)});
  }
  return recommendations;
}

AxisRate rate_of(const std::vector<TradePoint>& points, const TradeAxis& axis) {
  std::vector<double> values, largest;
  std::map<Quantity, std::vector<double>> errors;
  for (const std::size_t i : members_of(points, axis)) {
    values.push_back(axis.value(points[i].resolution));
    largest.push_back(points[i].error());
    for (const auto& [quantity, error] : points[i].errors) errors[quantity].push_back(error);
  }
  AxisRate rate{axis.name, {}, observed_rate(values, largest)};
  for (const auto& [quantity, list] : errors)
    if (list.size() == values.size()) rate.slope[quantity] = observed_rate(values, list);
  return rate;
}

}  // namespace

std::vector<std::size_t> members_of(const std::vector<TradePoint>& points, const TradeAxis& axis) {
  std::vector<std::size_t> members;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i].sweeps.count(axis.name) > 0 && !points[i].errors.empty()) members.push_back(i);
  std::stable_sort(members.begin(), members.end(), [&](std::size_t a, std::size_t b) {
    return axis.value(points[a].resolution) < axis.value(points[b].resolution);
  });
  if (axis.finer_is_smaller) std::reverse(members.begin(), members.end());
  return members;
}

Trade compute_trade(const PreparedCase& prepared, const TradePlan& plan) {
  Trade trade{closed_form(prepared)};
  const auto reference =
      quantities_of(trade.closed_form.answer, prepared.fem.units, prepared.fem.worn_edge.has_value());
  trade.springs = spring_levels(prepared, reference);
  trade.points = condensed_points(prepared, plan, reference);
  for (const auto& resolution : plan.full) trade.full.push_back(full_level(prepared, resolution));
  std::vector<ErrorAndSeconds> costs;
  for (const auto& point : trade.points) costs.push_back({point.error(), point.seconds});
  trade.front = pareto_front(costs);
  for (const auto& axis : trade_axes())
    if (axis.has_order) trade.rates.push_back(rate_of(trade.points, axis));
  trade.recommendations = recommendations_of(prepared, plan, trade.points);
  return trade;
}

}  // namespace fretval
