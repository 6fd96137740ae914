#include <algorithm>

#include "comparison/report/sections/sections.h"
#include "comparison/report/text/numbers.h"

namespace fretval {
namespace {

using nlohmann::ordered_json;

/// What the proofs of results took together.
struct Totals {
  double seconds = 0, time_steps = 0, cycles = 0, memory = 0;
  std::size_t computations = 0;
  int bodies = 0, from_store = 0;
  bool complete = true;  ///< false: a result is of a version that kept those of the chosen resolution alone
};

Totals totals_of(const std::vector<StoredResult>& results) {
  Totals totals;
  for (const auto& r : results) {
    const auto& cost = r.json.at("cost");
    const auto all = cost.value("all", ordered_json::object());
    totals.complete = totals.complete && !all.empty();
    totals.seconds += all.value("seconds", 0.0);
    totals.time_steps += all.value("time_steps", 0.0);
    totals.cycles += all.value("cycles", 0.0);
    totals.computations += all.value("computations", std::size_t{0});
    totals.memory = std::max(totals.memory, cost.value("peak_memory_bytes", 0.0));
    totals.bodies += all.empty() ? cost.value("bodies", 0) : all.value("bodies", 0);
    totals.from_store += all.empty() ? cost.value("bodies_from_store", 0) : all.value("bodies_from_store", 0);
  }
  return totals;
}

}  // namespace

Filling cost_section(const std::vector<StoredResult>& results) {
  const auto totals = totals_of(results);
  const auto& first = results.front().json.at("cost");
  Filling filling{{"template", "cost"},
                  {"case", "A case like " + results.front().name()},
                  {"dofs", first.value("dofs", 0)},
                  {"steps", first.value("time_steps", 0L)},
                  {"cycles", counted(first.value("cycles", std::size_t{0}), "cycle")},
                  {"seconds", number_text(first.at("seconds").value("friction_history", 0.0), "{:.2f}")},
                  {"megabytes", number_text(totals.memory / 1e6, "{:.0f}")}};
  if (totals.complete)
    filling["all"] = {
        {"cases", results.size() == 1 ? "Its proof" : "The proofs of all " + counted(results.size(), "case")},
        {"computations", counted(totals.computations, "computation")},
        {"steps", number_text(totals.time_steps, "{:.3g}")},
        {"cycles", number_text(totals.cycles, "{:.3g}")},
        {"seconds", number_text(totals.seconds, "{:.3g}")}};
  if (totals.bodies > 0)
    filling["bodies"] = {{"counted", results.size() == 1 ? "" : ", counted in each case that uses it"},
                         {"made", totals.bodies - totals.from_store},
                         {"kept", totals.from_store}};
  return filling;
}

}  // namespace fretval
