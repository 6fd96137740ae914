#include "comparison/verification/random_cases/random_json.h"

#include "comparison/support/json.h"
#include "comparison/verification/random_cases/random_table.h"

namespace fretval {
namespace {

using nlohmann::ordered_json;

ordered_json json_of(const SoakDistribution& d) {
  return {{"comparisons", d.n},
          {"above_bar", d.n - d.n_covered},
          {"unbounded", d.n_unbounded},
          {"median_error", or_null(d.median_error)},
          {"high_error", or_null(d.high_error)},
          {"median_bar", or_null(d.median_bar)},
          {"high_bar", or_null(d.high_bar)},
          {"share_above_1e-2", d.wide},
          {"share_above_1e-1", d.very_wide},
          {"low_effectivity", or_null(d.low_effectivity)},
          {"median_effectivity", or_null(d.median_effectivity)}};
}

ordered_json json_of(const SoakRecord& record) {
  ordered_json json{{"number", record.draw.number},
                    {"scene", scene_text(record)},
                    {"failure", or_null(failure_of(record))},
                    {"quantity", nullptr}};
  if (const auto worst = record.worst()) {
    const auto& e = *record.errors[*worst];
    json["quantity"] = soak_quantities[*worst];
    json["mdr"] = or_null(e.mdr);
    json["fe"] = or_null(e.fe);
    json["error"] = or_null(e.error());
    json["bar"] = or_null(e.bar);
    json["share"] = or_null(e.share());
    json["largest_share"] = name_of(e.source);
  }
  json["case_file"] = case_text(soak_entries(record.draw));
  return json;
}

ordered_json memory_json(const SoakRun& run, const std::optional<MemoryGrowth>& growth) {
  ordered_json json{{"start", nullptr}, {"end", nullptr}, {"bytes_per_case", nullptr}, {"flat", nullptr}};
  if (growth)
    json = {{"start", growth->start},
            {"end", growth->end},
            {"bytes_per_case", growth->bytes_per_case()},
            {"flat", growth->is_flat()}};
  json["samples"] = ordered_json::array();
  for (const auto& sample : run.memory) json["samples"].push_back({{"cases", sample.n_cases}, {"bytes", sample.bytes}});
  return json;
}

}  // namespace

ordered_json soak_json(const SoakRun& run, const SoakSummary& summary) {
  auto quantities = ordered_json::object();
  for (const auto& distribution : summary.distributions) quantities[distribution.quantity] = json_of(distribution);
  auto worst = ordered_json::array();
  for (const auto* record : summary.worst) worst.push_back(json_of(*record));
  return {{"summary",
           {{"pass", summary.passes()},
            {"verdict", verdict_text(summary)},
            {"seed", run.seed},
            {"cases", summary.n_cases},
            {"comparisons", summary.n_comparisons},
            {"failures", summary.n_failures},
            {"above_bar", summary.n_above_bar},
            {"drawn_again", summary.n_drawn_again},
            {"seconds", run.seconds},
            {"histories", run.n_histories}}},
          {"quantities", std::move(quantities)},
          {"memory", memory_json(run, summary.memory)},
          {"worst", std::move(worst)}};
}

}  // namespace fretval
