#include "comparison/verification/trade/trade.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "comparison/accuracy/verdict.h"
#include "comparison/simulation/fem_case/resolution.h"
#include "comparison/support/json.h"

namespace fretval {
namespace {

using nlohmann::ordered_json;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double same_error = 1e-6;  // histories that differ in nothing that matters differ in roundoff
constexpr double floors = 3;         // an error within so many times the smallest one is not its own

std::vector<std::size_t> condensed_without_failure(const std::vector<TradeLevel>& levels) {
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < levels.size(); ++i)
    if (levels[i].kind == "condensed" && std::isfinite(levels[i].error())) all.push_back(i);
  return all;
}

ordered_json level_json(const TradeLevel& level) {
  auto errors = ordered_json::object();
  for (const auto& [quantity, error] : level.errors) errors[name_of(quantity)] = error;
  return {{"kind", level.kind},
          {"setting", level.setting},
          {"axes", level.axes},
          {"error", or_null(level.error())},
          {"errors", errors},
          {"seconds", or_null(level.seconds)},
          {"failure", or_null(level.failure)}};
}

/// The levels that an axis alone varies, coarsest first, and the power of its values that the error goes with; none for
/// the order of the elements, which is an exponent itself.
ordered_json axis_json(const std::vector<TradeLevel>& levels, const std::string& axis) {
  auto members = condensed_without_failure(levels);
  members.erase(
      std::remove_if(members.begin(), members.end(), [&](std::size_t i) { return levels[i].axes.count(axis) == 0; }),
      members.end());
  std::sort(members.begin(), members.end(),
            [&](std::size_t a, std::size_t b) { return levels[a].axes.at(axis) < levels[b].axes.at(axis); });
  if (axis == "grading") std::reverse(members.begin(), members.end());
  std::vector<double> values, errors;
  for (const std::size_t i : members) {
    values.push_back(levels[i].axes.at(axis));
    errors.push_back(levels[i].error());
  }
  const auto rate = axis == "order" ? std::nullopt : observed_rate(values, errors);
  return {{"levels", members},
          {"values", values},
          {"errors", errors},
          {"power", rate ? ordered_json(rate->slope) : ordered_json(nullptr)}};
}

}  // namespace

std::vector<std::size_t> front_of(const std::vector<TradeLevel>& levels) {
  auto order = condensed_without_failure(levels);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::make_pair(levels[a].seconds, levels[a].error()) < std::make_pair(levels[b].seconds, levels[b].error());
  });
  std::vector<std::size_t> front;
  double smallest = infinity;
  for (const std::size_t i : order) {
    if (levels[i].error() >= (1 - same_error) * smallest) continue;
    smallest = levels[i].error();
    front.push_back(i);
  }
  return front;
}

std::optional<std::size_t> cheapest(const std::vector<TradeLevel>& levels, double tolerance) {
  std::optional<std::size_t> best;
  for (const std::size_t i : condensed_without_failure(levels))
    if (meets(levels[i].errors, tolerance) && (!best || levels[i].seconds < levels[*best].seconds)) best = i;
  return best;
}

bool meets(const Quantities& errors, double tolerance) {
  const auto tolerances = tolerances_of(tolerance);
  return !errors.empty() && std::all_of(errors.begin(), errors.end(), [&](const auto& entry) {
    return entry.second <= tolerance_of(tolerances, entry.first);
  });
}

std::optional<LogSlope> observed_rate(std::vector<double> values, std::vector<double> errors) {
  if (errors.empty()) return std::nullopt;
  const double floor = floors * *std::min_element(errors.begin(), errors.end());
  const auto end = std::find_if_not(errors.begin(), errors.end(), [=](double error) { return error > floor; });
  values.resize(static_cast<std::size_t>(end - errors.begin()));
  errors.resize(values.size());
  return log_slope(values, errors, 0);
}

ordered_json trade_json(const PreparedCase& prepared, const TradePlan& plan, const std::vector<TradeLevel>& levels) {
  ordered_json json{{"name", prepared.input.name},
                    {"file", prepared.input.file},
                    {"reference_setting", resolution_json(plan.reference)},
                    {"levels", ordered_json::array()},
                    {"front", front_of(levels)}};
  for (const auto& level : levels) json["levels"].push_back(level_json(level));
  for (const char* axis : {"rings", "order", "grading", "far radius", "steps"})
    json["axes"][axis] = axis_json(levels, axis);
  json["recommendations"] = ordered_json::array();
  for (const double tolerance : plan.tolerances) {
    const auto found = plan.settings.find(chosen_resolution(tolerance, prepared.fem));
    const auto chosen = static_cast<std::size_t>(std::distance(plan.settings.begin(), found));
    json["recommendations"].push_back({{"tolerance", tolerance},
                                       {"cheapest", or_null(cheapest(levels, tolerance))},
                                       {"chosen", chosen},
                                       {"chosen_meets_tolerance", meets(levels.at(chosen).errors, tolerance)}});
  }
  return json;
}

}  // namespace fretval
