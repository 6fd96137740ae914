#include <algorithm>
#include <nlohmann/json.hpp>

#include "comparison/simulation/resolution_json.h"
#include "comparison/support/json.h"
#include "comparison/verification/trade/trade.h"

namespace fretval {
namespace {

using nlohmann::ordered_json;

ordered_json by_name(const Quantities& values) {
  auto json = ordered_json::object();
  for (const auto& [quantity, value] : values) json[name_of(quantity)] = value;
  return json;
}

ordered_json point_json(const TradePoint& point) {
  return {{"setting", resolution_json(point.resolution)},
          {"sweeps", point.sweeps},
          {"error", or_null(point.error())},
          {"errors", by_name(point.errors)},
          {"seconds", point.seconds},
          {"memory_bytes", or_null(point.memory_bytes)},
          {"cost", point.cost},
          {"failure", or_null(point.failure)}};
}

ordered_json spring_json(const SpringLevel& level) {
  const auto& s = level.setting;
  return {{"setting",
           {{"springs", s.n_springs},
            {"steps_per_cycle", s.steps_per_cycle},
            {"ramp_periods", s.n_ramp_periods},
            {"periodicity", s.periodicity}}},
          {"error", or_null(largest_of(level.errors))},
          {"errors", by_name(level.errors)},
          {"seconds", level.seconds},
          {"failure", or_null(level.failure)}};
}

/// condensed: at the same setting, whose error it has and whose steps it is extrapolated to.
ordered_json full_json(const FullLevel& level, const TradePoint& condensed) {
  return {{"setting", resolution_json(level.resolution)},
          {"error_of_the_condensed_point", or_null(condensed.error())},
          {"measured",
           {{"body_seconds", level.body_seconds},
            {"seconds_per_normal_step", level.seconds_per_normal_step},
            {"seconds_per_friction_step", level.seconds_per_friction_step}}},
          {"extrapolated_seconds",
           level.failure.empty() ? ordered_json(level.seconds(condensed.n_normal_steps, condensed.n_friction_steps))
                                 : ordered_json(nullptr)},
          {"memory_bytes", or_null(level.memory_bytes)},
          {"dofs", level.n_dofs},
          {"failure", or_null(level.failure)}};
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
    json[rate.axis] = {{"largest_error", slope_json(rate.largest_error)}, {"quantities", slopes}};
  }
  return json;
}

}  // namespace

ordered_json trade_json(const PreparedCase& prepared, const TradePlan& plan, const Trade& trade) {
  ordered_json json{
      {"name", prepared.input.name},
      {"file", prepared.input.file},
      {"mdr", to_json(trade.closed_form.answer)},
      {"reference_setting", resolution_json(plan.reference)},
      {"closed_form",
       {{"seconds", trade.closed_form.seconds}, {"stick_radii_seconds", trade.closed_form.stick_radii_seconds}}}};
  for (const char* key : {"springs", "points", "full", "recommendations"}) json[key] = ordered_json::array();
  for (const auto& level : trade.springs) json["springs"].push_back(spring_json(level));
  for (const auto& point : trade.points) json["points"].push_back(point_json(point));
  for (const auto& level : trade.full) {
    const auto same = [&](const TradePoint& point) { return point.resolution == level.resolution; };
    json["full"].push_back(full_json(level, *std::find_if(trade.points.begin(), trade.points.end(), same)));
  }
  json["front"] = trade.front;
  json["rates"] = rates_json(trade);
  for (const auto& r : trade.recommendations)
    json["recommendations"].push_back({{"tolerance", r.tolerance},
                                       {"cheapest", or_null(r.cheapest)},
                                       {"chosen", r.chosen},
                                       {"chosen_meets_tolerance", r.chosen_meets}});
  return json;
}

}  // namespace fretval
