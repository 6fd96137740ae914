#include "comparison/verification/trade/trade_json.h"

#include "comparison/simulation/resolution_json.h"
#include "comparison/support/json.h"

namespace fretval {
namespace {

using nlohmann::ordered_json;

ordered_json by_name(const Quantities& values) {
  auto json = ordered_json::object();
  for (const auto& [quantity, value] : values) json[name_of(quantity)] = value;
  return json;
}

ordered_json setting_json(const Resolution& r) {
  return {{"rings_per_radius", r.elements_per_radius},
          {"element_order", r.degree},
          {"grading", r.growth},
          {"far_radius", r.far_radius},
          {"steps_per_cycle", r.steps_per_cycle},
          {"ramp_cycles", r.n_ramp_cycles},
          {"periodicity", r.periodicity},
          {"creep_cycles", r.n_creep_cycles},
          {"worn_edge_ring", r.worn_edge_ring},
          {"active_set_slack", r.active_set_slack},
          {"focus", r.focus ? focus_json(*r.focus) : ordered_json(nullptr)}};
}

ordered_json point_json(const TradePoint& point) {
  auto sweeps = ordered_json::array();
  for (const Sweep sweep : point.setting.sweeps) sweeps.push_back(name_of(sweep));
  const auto& s = point.seconds;
  return {{"setting", setting_json(point.setting.resolution)},
          {"sweeps", sweeps},
          {"error", or_null(point.error())},
          {"errors", by_name(point.errors)},
          {"seconds",
           {{"mesh", s.body.mesh},
            {"assembly", s.body.assembly},
            {"factorisation", s.body.factorisation},
            {"normal_history", s.normal_history},
            {"friction_history", s.friction_history},
            {"total", s.total()}}},
          {"memory_bytes", or_null(point.memory_bytes)},
          {"dofs", point.n_dofs},
          {"contact_nodes", point.n_contact_nodes},
          {"rings", point.n_rings},
          {"normal_steps", point.n_normal_steps},
          {"friction_steps", point.n_friction_steps},
          {"cycles", point.n_cycles},
          {"failure", or_null(point.failure)}};
}

ordered_json spring_json(const SpringPoint& point) {
  const auto& s = point.setting;
  return {{"setting",
           {{"springs", s.n_springs},
            {"steps_per_period", s.steps_per_period},
            {"ramp_periods", s.n_ramp_periods},
            {"periodicity", s.periodicity}}},
          {"error", or_null(largest_of(point.errors))},
          {"errors", by_name(point.errors)},
          {"seconds", or_null(point.seconds)},
          {"memory_bytes_estimated", point.memory_bytes},
          {"periods", point.n_periods},
          {"failure", or_null(point.failure)}};
}

ordered_json full_json(const FullLevel& level, const TradePoint& condensed) {
  const auto& p = level.point;
  const bool done = p.failure.empty();
  return {{"setting", setting_json(p.resolution)},
          {"condensed_point", level.condensed},
          {"error_of_the_condensed_point", or_null(condensed.error())},
          {"largest_relative_difference_from_condensed",
           done ? ordered_json{{"pressure", p.pressure_difference}, {"traction", p.traction_difference}}
                : ordered_json(nullptr)},
          {"measured",
           {{"normal_steps", p.n_normal_steps},
            {"friction_steps", p.n_friction_steps},
            {"body_seconds", p.body_seconds},
            {"normal_seconds", p.normal_seconds},
            {"friction_seconds", p.friction_seconds},
            {"seconds_per_normal_step", p.seconds_per_normal_step()},
            {"seconds_per_friction_step", p.seconds_per_friction_step()}}},
          {"seconds_of_the_whole_history_extrapolated_from_the_measured_steps",
           done ? ordered_json(level.extrapolated_seconds) : ordered_json(nullptr)},
          {"memory_bytes_measured", or_null(p.memory_bytes)},
          {"dofs", p.n_dofs},
          {"failure", or_null(p.failure)}};
}

ordered_json slope_json(const std::optional<LogSlope>& slope) {
  if (!slope) return nullptr;
  return {{"power", slope->slope}, {"points", slope->n_points}};
}

ordered_json rates_json(const Trade& trade) {
  ordered_json json = ordered_json::object();
  for (const auto& rate : trade.rates) {
    ordered_json slopes = ordered_json::object();
    for (const auto& [quantity, slope] : rate.slope) slopes[name_of(quantity)] = slope_json(slope);
    json[name_of(rate.sweep)] = {{"largest_error", slope_json(rate.largest_error)}, {"quantities", slopes}};
  }
  return json;
}

}  // namespace

ordered_json trade_json(const PreparedCase& prepared, const TradePlan& plan, const Trade& trade) {
  ordered_json json{{"name", prepared.input.name},
                    {"file", prepared.input.file},
                    {"mdr", to_json(trade.reference.answer)},
                    {"reference_setting", setting_json(plan.reference)},
                    {"repetitions", plan.n_repetitions},
                    {"closed_form",
                     {{"error", 0},
                      {"seconds", trade.reference.seconds},
                      {"stick_radii_seconds", trade.reference.stick_radii_seconds},
                      {"repetitions", trade.reference.n_repetitions}}}};
  for (const char* key : {"springs", "points", "full"}) json[key] = ordered_json::array();
  for (const auto& point : trade.springs) json["springs"].push_back(spring_json(point));
  for (const auto& point : trade.points) json["points"].push_back(point_json(point));
  for (const auto& level : trade.full) json["full"].push_back(full_json(level, trade.points.at(level.condensed)));
  json["front"] = trade.front;
  json["rates"] = rates_json(trade);
  json["seconds_over_rings"] = slope_json(trade.seconds_over_rings);
  json["recommendations"] = ordered_json::array();
  for (const auto& r : trade.recommendations)
    json["recommendations"].push_back({{"tolerance", r.tolerance},
                                       {"cheapest", or_null(r.cheapest)},
                                       {"chosen", r.chosen},
                                       {"chosen_meets_tolerance", r.chosen_meets}});
  return json;
}

}  // namespace fretval
