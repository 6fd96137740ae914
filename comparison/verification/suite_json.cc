#include "comparison/verification/suite_json.h"

#include "comparison/support/json.h"
#include "comparison/support/junit.h"
#include "comparison/verification/suite_summary.h"

namespace fretval {
namespace {

using nlohmann::ordered_json;

ordered_json json_of(const Spread& spread) {
  return {{"low", or_null(spread.low)}, {"median", or_null(spread.median)}, {"high", or_null(spread.high)}};
}

ordered_json json_of(const QuantitySummary& s) {
  return {{"quantity", name_of(s.quantity)}, {"tolerance", s.tolerance}, {"errors", s.n},
          {"above_bar", s.n_above},          {"wide", s.n_wide},         {"unbounded", s.n_unbounded},
          {"error", json_of(s.error)},       {"bar", json_of(s.bar)},    {"effectivity", json_of(s.effectivity)}};
}

ordered_json json_of(const SuiteRow& row) {
  auto quantities = ordered_json::object();
  for (const auto& [quantity, q] : row.compared)
    quantities[name_of(quantity)] = {{"mdr", or_null(q.mdr)},       {"fe", or_null(q.fe)},
                                     {"error", or_null(q.error())}, {"tolerance", q.tolerance},
                                     {"bar", or_null(q.bar)},       {"source", or_null(q.source)}};
  const auto* worst = worst_of(row);
  return {{"family", row.asked.family},
          {"name", row.asked.name},
          {"verdict", name_of(verdict_of(row))},
          {"remark", or_null(remark_of(row))},
          {"refusal", or_null(row.refusal)},
          {"expected_refusal", or_null(row.asked.refusal)},
          {"second_way", static_cast<bool>(row.asked.second_way)},
          {"quantities", std::move(quantities)},
          {"worst", or_null(std::string(worst ? name_of(worst->first) : ""))},
          {"seconds", row.seconds},
          {"refinements", row.n_refinements},
          {"computations", row.n_computations},
          {"case_file", row.asked.text}};
}

}  // namespace

ordered_json suite_json(const SuiteRun& run) {
  const auto errors = count_errors(run.rows);
  long n_computations = 0;
  for (const auto& row : run.rows) n_computations += row.n_computations;
  auto checks = ordered_json::array(), quantities = ordered_json::array(), rows = ordered_json::array();
  for (const auto& check : run.checks)
    checks.push_back({{"name", check.name}, {"finding", check.finding}, {"failure", or_null(check.failure)}});
  for (const auto& summary : quantity_summaries(run.rows)) quantities.push_back(json_of(summary));
  for (const auto* row : shown_rows(run.rows)) rows.push_back(json_of(*row));
  return {{"suite", run.name},
          {"about", run.about},
          {"summary",
           {{"pass", run.passes()},
            {"cases", run.rows.size()},
            {"agree", count(run.rows, RowVerdict::agrees)},
            {"refused", count(run.rows, RowVerdict::refused)},
            {"inconclusive", count(run.rows, RowVerdict::inconclusive)},
            {"fail", count(run.rows, RowVerdict::fails)},
            {"errors", errors.n},
            {"above_bar", errors.n_above},
            {"computations", n_computations},
            {"seconds", run.seconds}}},
          {"checks", std::move(checks)},
          {"quantities", std::move(quantities)},
          {"rows", std::move(rows)}};
}

std::string suite_junit(const SuiteRun& run) {
  std::vector<JUnitCase> cases;
  for (const auto& row : run.rows)
    cases.push_back({title_of(row.asked) + (verdict_of(row) == RowVerdict::inconclusive ? " (inconclusive)" : ""),
                     failure_of(row)});
  for (const auto& check : run.checks) cases.push_back({check.name, check.failure});
  return junit_document("fretval check " + run.name, cases);
}

}  // namespace fretval
