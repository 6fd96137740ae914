#include "comparison/verification/trade/trade.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparison/simulation/compute_case.h"
#include "comparison/support/log.h"
#include "comparison/support/resident_memory.h"
#include "fem/support/solver_error.h"
#include "meshes/mesh_error.h"

namespace fretval {
namespace {

TradePoint point_of(const PlannedSetting& setting, const FemCase& fem, const FeAnswer& answer,
                    const Quantities& reference) {
  TradePoint point;
  point.setting = setting;
  point.seconds = {answer.body->cost, answer.seconds.normal, answer.seconds.friction};
  point.n_dofs = answer.body->n_dofs;
  point.n_contact_nodes = answer.body->n_contact_nodes;
  point.n_rings = static_cast<Eigen::Index>(answer.body->radii.size()) - 1;
  point.errors = errors_of(quantities_of(answer, fem.units), reference);
  point.n_normal_steps = static_cast<long>(answer.normal.n_cycles) * answer.normal.steps_per_cycle;
  point.n_friction_steps = answer.n_steps;
  point.n_cycles = answer.n_cycles;
  return point;
}

TradePoint failed(const PlannedSetting& setting, const std::string& failure) {
  log::warn(fmt::format("a setting failed: {}", failure));
  TradePoint point;
  point.setting = setting;
  point.failure = failure;
  return point;
}

TradePoint compute_point(const PreparedCase& prepared, const PlannedSetting& setting, const Quantities& reference) {
  const ResidentGrowth growth;
  try {
    BodyStore its_own;
    auto point = point_of(setting, prepared.fem, compute_case(prepared.fem, setting.resolution, its_own), reference);
    point.memory_bytes = growth.peak_bytes();
    return point;
  } catch (const fem::SolverError& error) {
    return failed(setting, error.what());
  } catch (const meshes::MeshError& error) {
    return failed(setting, error.what());
  }
}

TradeSeconds fastest(const TradeSeconds& a, const TradeSeconds& b) {
  return {{std::min(a.body.mesh, b.body.mesh), std::min(a.body.assembly, b.body.assembly),
           std::min(a.body.factorisation, b.body.factorisation)},
          std::min(a.normal_history, b.normal_history),
          std::min(a.friction_history, b.friction_history)};
}

std::vector<TradePoint> condensed_points(const PreparedCase& prepared, const TradePlan& plan,
                                         const Quantities& reference) {
  std::vector<TradePoint> points;
  // The first body of a process also pays for what its libraries load and allocate once and for all.
  if (!plan.settings.empty()) make_body(at_resolution(prepared.fem, plan.settings.front().resolution).body);
  for (const auto& setting : plan.settings) {
    auto point = compute_point(prepared, setting, reference);
    for (int run = 1; run < plan.n_repetitions && point.failure.empty(); ++run)
      point.seconds = fastest(point.seconds, compute_point(prepared, setting, reference).seconds);
    points.push_back(std::move(point));
  }
  return points;
}

std::size_t index_of(const std::vector<TradePoint>& points, const Resolution& resolution) {
  const auto found = std::find_if(points.begin(), points.end(),
                                  [&](const TradePoint& p) { return p.setting.resolution == resolution; });
  return static_cast<std::size_t>(found - points.begin());
}

std::vector<FullLevel> full_levels(const PreparedCase& prepared, const TradePlan& plan,
                                   const std::vector<TradePoint>& points) {
  std::vector<FullLevel> levels;
  for (const auto& resolution : plan.full) {
    const std::size_t i = index_of(points, resolution);
    auto point = full_point(prepared, resolution);
    const double seconds = point.extrapolated_seconds(points.at(i).n_normal_steps, points.at(i).n_friction_steps);
    log::info(fmt::format("full finite elements: {} dofs, {} + {} steps in {:.1f} + {:.1f} s", point.n_dofs,
                          point.n_normal_steps, point.n_friction_steps, point.normal_seconds, point.friction_seconds));
    levels.push_back({std::move(point), i, seconds});
  }
  return levels;
}

std::vector<Recommendation> recommendations_of(const PreparedCase& prepared, const TradePlan& plan,
                                               const std::vector<TradePoint>& points) {
  std::vector<Candidate> candidates;
  candidates.reserve(points.size());
  for (const auto& point : points) candidates.push_back({point.errors, point.seconds.total()});
  std::vector<Recommendation> recommendations;
  for (const double tolerance : plan.tolerances) {
    const std::size_t chosen = index_of(points, chosen_resolution(tolerance, prepared.fem));
    recommendations.push_back(
        {tolerance, cheapest(candidates, tolerance), chosen, meets(points.at(chosen).errors, tolerance)});
  }
  return recommendations;
}

}  // namespace

double TradeSeconds::total() const {
  return body.total() + normal_history + friction_history;
}

double axis_value(Sweep sweep, const Resolution& resolution) {
  switch (sweep) {
    case Sweep::element_order:
      return resolution.degree;
    case Sweep::grading:
      return resolution.growth;
    case Sweep::far_field:
      return resolution.far_radius;
    case Sweep::time_step:
      return resolution.steps_per_cycle;
    default:
      return resolution.elements_per_radius;
  }
}

std::vector<std::size_t> members_of(const std::vector<TradePoint>& points, Sweep sweep) {
  std::vector<std::size_t> members;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i].setting.sweeps.count(sweep) > 0 && !points[i].errors.empty()) members.push_back(i);
  std::stable_sort(members.begin(), members.end(), [&](std::size_t a, std::size_t b) {
    return axis_value(sweep, points[a].setting.resolution) < axis_value(sweep, points[b].setting.resolution);
  });
  return members;
}

AxisRate rate_of(const std::vector<TradePoint>& points, Sweep sweep) {
  std::vector<double> values, largest;
  std::map<Quantity, std::vector<double>> errors;
  auto members = members_of(points, sweep);
  if (sweep == Sweep::grading) std::reverse(members.begin(), members.end());  // coarsest first
  for (const std::size_t i : members) {
    values.push_back(axis_value(sweep, points[i].setting.resolution));
    largest.push_back(points[i].error());
    for (const auto& [quantity, error] : points[i].errors) errors[quantity].push_back(error);
  }
  AxisRate rate{sweep, {}, observed_rate(values, largest)};
  for (const auto& [quantity, list] : errors)
    if (list.size() == values.size()) rate.slope[quantity] = observed_rate(values, list);
  return rate;
}

Trade compute_trade(const PreparedCase& prepared, const TradePlan& plan) {
  Trade trade{closed_form(prepared), {}, {}, {}, {}, {}, {}, {}};
  const auto& reference = trade.reference.measures;
  if (has_springs(prepared))
    for (const auto& setting : plan.springs)
      trade.springs.push_back(spring_point(prepared, setting, reference, plan.n_repetitions));
  trade.points = condensed_points(prepared, plan, reference);
  trade.full = full_levels(prepared, plan, trade.points);
  std::vector<ErrorAndSeconds> costs;
  for (const auto& point : trade.points) costs.push_back({point.error(), point.seconds.total()});
  trade.front = pareto_front(costs);
  for (const Sweep sweep : rated_sweeps) trade.rates.push_back(rate_of(trade.points, sweep));
  std::vector<double> rings, seconds;
  for (const std::size_t i : members_of(trade.points, Sweep::rings)) {
    rings.push_back(trade.points[i].setting.resolution.elements_per_radius);
    seconds.push_back(costs[i].seconds);
  }
  trade.seconds_over_rings = log_slope(rings, seconds, 0);
  trade.recommendations = recommendations_of(prepared, plan, trade.points);
  return trade;
}

}  // namespace fretval
