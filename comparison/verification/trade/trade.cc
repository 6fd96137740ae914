#include "comparison/verification/trade/trade.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparison/simulation/fe_run.h"
#include "comparison/support/log.h"
#include "comparison/support/resident_memory.h"

namespace fretval {
namespace {

/// Numbers that a history keeps for its rings: pressure and force per instant; margins, reserves, slip, work and
/// displacements per ring, with three samples for each of four minima; tractions of a period; the memory of either
/// direction, one field per branch.
double history_bytes(const ProbeAnswer& answer, const FemCase& scene) {
  const auto& normal = answer.normal->history;
  const auto n_rings = static_cast<double>(normal.pressure.rows());
  const auto n_instants = static_cast<double>(normal.pressure.cols());
  const auto& friction = answer.fe.friction;
  const double per_ring = 12 + 12 + 2.0 * static_cast<double>(scene.relaxation.moduli.size());
  return 8 * (n_rings * (n_instants + per_ring + static_cast<double>(friction.traction.cols())) + 3 * n_instants +
              static_cast<double>(friction.force.size()));
}

TradePoint point_of(const PlannedSetting& setting, const FemCase& scene, const ProbeAnswer& answer,
                    const Measures& reference) {
  TradePoint point;
  point.setting = setting;
  point.failure = answer.failure;
  if (answer.body) {
    point.seconds.body = answer.body->cost;
    point.n_dofs = answer.body->n_dofs;
    point.n_contact_nodes = answer.body->n_contact_nodes;
    point.n_rings = static_cast<Eigen::Index>(answer.body->radii.size()) - 1;
  }
  if (!answer.failure.empty()) return point;
  point.errors = errors_of(measures_of(answer.fe, scene.units), reference);
  point.seconds.normal_history = answer.normal->seconds;
  point.seconds.friction_history = answer.fe.seconds;
  point.memory.histories = history_bytes(answer, scene);
  point.n_normal_steps = answer.normal->history.pressure.cols() - 1;
  point.n_friction_steps = answer.fe.n_steps;
  point.n_cycles = answer.fe.n_cycles;
  return point;
}

TradeSeconds fastest(const TradeSeconds& a, const TradeSeconds& b) {
  return {{std::min(a.body.mesh, b.body.mesh), std::min(a.body.assembly, b.body.assembly),
           std::min(a.body.factorisation, b.body.factorisation)},
          std::min(a.normal_history, b.normal_history),
          std::min(a.friction_history, b.friction_history)};
}

/// The first body of a process also pays for what its libraries load and allocate once and for all.
void warm_up(const std::vector<Probe>& probes) {
  const auto coarsest = std::min_element(
      probes.begin(), probes.end(), [](const Probe& a, const Probe& b) { return a.fem.resolution < b.fem.resolution; });
  run_probes(
      {*coarsest}, [](const BodySpecification& s) { return condensed(make_body(s)); }, [](auto&&...) {});
}

std::vector<TradePoint> condensed_points(const PreparedCase& prepared, const TradePlan& plan,
                                         const Measures& reference) {
  std::vector<Probe> probes;
  probes.reserve(plan.settings.size());
  for (const auto& setting : plan.settings)
    probes.push_back({&prepared.scene, at_resolution(prepared.fem, setting.resolution)});
  if (probes.empty()) return {};
  warm_up(probes);
  std::optional<double> body_peak;  // of the body that is being worked on: they come one after the other
  const auto measured_body = [&](const BodySpecification& specification) {
    const ResidentGrowth growth;
    Body body = make_body(specification);
    body_peak = growth.peak_bytes();
    return condensed(std::move(body));
  };
  std::vector<TradePoint> points(probes.size());
  for (int run = 0; run < plan.n_repetitions; ++run)
    run_probes(
        probes, measured_body,
        [&](std::size_t i, ProbeAnswer&& answer) {
          auto point = point_of(plan.settings[i], probes[i].fem, answer, reference);
          if (point.failure.empty()) point.memory.body_peak = body_peak;
          if (run > 0) point.seconds = fastest(points[i].seconds, point.seconds);
          if (run == 0 && !point.failure.empty()) log::warn(fmt::format("a setting failed: {}", point.failure));
          points[i] = std::move(point);
        },
        Schedule::exclusive);
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

std::optional<double> TradeMemory::total() const {
  if (!body_peak) return std::nullopt;
  return *body_peak + histories;
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
  std::map<std::string, std::vector<double>> errors;
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
