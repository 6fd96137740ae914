#include "comparison/verification/tolerance/tolerance_json.h"

#include "comparison/simulation/resolution_json.h"
#include "comparison/support/json.h"
#include "comparison/verification/tolerance/tolerance_table.h"

namespace fretval {
namespace {

using nlohmann::ordered_json;

ordered_json json_of(const ToleranceSummary& s) {
  return {{"tolerance", s.tolerance},
          {"cases", s.n_cases},
          {"meet", s.n_meet},
          {"errors", s.n_errors},
          {"covered", s.n_covered},
          {"median_effectivity", or_null(s.median_effectivity)},
          {"high_effectivity", or_null(s.high_effectivity)},
          {"median_cost_ratio", or_null(s.median_cost_ratio)},
          {"largest_cost_ratio", or_null(s.largest_cost_ratio)},
          {"searched", s.n_searched},
          {"not_in_grid", s.n_not_in_grid},
          {"inconclusive", s.inconclusive}};
}

ordered_json json_of(const TrueErrors& errors, const ErrorBudget& budget) {
  auto json = ordered_json::object();
  for (const auto& [quantity, e] : errors) {
    json[quantity] = {{"error", or_null(e.error)}, {"tolerance", e.tolerance}, {"bar", or_null(e.bar)},
                      {"covered", e.covered()},    {"meets", e.meets()},       {"finding", name_of(e.finding())}};
    const auto bar = budget.find(quantity);
    if (bar == budget.end()) continue;
    for (const auto& share : bar->second.shares)
      json[quantity]["shares"][name_of(share.source)] = or_null(share.estimate);
  }
  return json;
}

ordered_json json_of(const Economised& economised) {
  auto resolutions = ordered_json::array();
  for (const auto& r : economised.resolutions) resolutions.push_back(resolution_json(r));
  return {{"resolutions", std::move(resolutions)},
          {"errors", json_of(economised.errors, {})},
          {"seconds", economised.seconds > 0 ? ordered_json(economised.seconds) : ordered_json(nullptr)}};
}

ordered_json json_of(const ToleranceRecord& record) {
  auto cheapest = ordered_json(nullptr);
  if (record.cheapest)
    cheapest = {{"resolution", resolution_json(record.cheapest->resolution)},
                {"seconds", record.cheapest->seconds},
                {"ratio", or_null(cost_ratio(record))}};
  return {{"name", record.name},
          {"tolerance", record.tolerance},
          {"failure", or_null(record.failure)},
          {"pass", record.passes()},
          {"errors", json_of(record.errors, record.budget)},
          {"resolution", resolution_json(record.resolution)},
          {"focus", focus_json(record.focus)},
          {"refinements", record.n_refinements},
          {"computations", record.n_probes},
          {"seconds", record.seconds},
          {"economised", json_of(record.economised)},
          {"searched", record.in_grid},
          {"cheapest", std::move(cheapest)}};
}

}  // namespace

ordered_json tolerance_json(const std::vector<ToleranceRecord>& records) {
  auto summary = ordered_json::array(), all = ordered_json::array();
  for (const auto& s : summaries(records)) summary.push_back(json_of(s));
  for (const auto& record : records) all.push_back(json_of(record));
  return {{"summary", std::move(summary)}, {"records", std::move(all)}};
}

}  // namespace fretval
