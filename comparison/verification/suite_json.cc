#include "comparison/verification/suite_json.h"

#include "comparison/support/json.h"
#include "comparison/support/junit.h"
#include "comparison/support/quantile.h"
#include "comparison/verification/suite_summary.h"

namespace fretval {
namespace {

using nlohmann::ordered_json;

/// 50 and 90 % of the values are not larger.
ordered_json spread(const std::vector<double>& values) {
  return {{"median", or_null(quantile(values, 0.5))}, {"high", or_null(quantile(values, 0.9))}};
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
          {"quantities", std::move(quantities)},
          {"worst", or_null(std::string(worst ? name_of(worst->first) : ""))},
          {"seconds", row.seconds},
          {"refinements", row.n_refinements},
          {"computations", row.n_computations},
          {"case_file", row.asked.text}};
}

}  // namespace

ordered_json suite_json(const SuiteRun& run) {
  long n_computations = 0;
  std::size_t n_errors = 0, n_above = 0;
  for (const auto& row : run.rows) n_computations += row.n_computations;
  auto quantities = ordered_json::array(), rows = ordered_json::array();
  for (const auto& [key, s] : quantity_summaries(run.rows)) {
    n_errors += s.n;
    n_above += s.n_above;
    quantities.push_back({{"quantity", name_of(key.first)},
                          {"tolerance", key.second},
                          {"errors", s.n},
                          {"above_bar", s.n_above},
                          {"wide", s.n_wide},
                          {"error", spread(s.errors)},
                          {"bar", spread(s.bars)},
                          {"effectivity", spread(s.effectivities)}});
  }
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
            {"errors", n_errors},
            {"above_bar", n_above},
            {"computations", n_computations},
            {"seconds", run.seconds}}},
          {"quantities", std::move(quantities)},
          {"rows", std::move(rows)}};
}

std::string suite_junit(const SuiteRun& run) {
  std::vector<JUnitCase> cases;
  for (const auto& row : run.rows)
    cases.push_back({title_of(row.asked) + (verdict_of(row) == RowVerdict::inconclusive ? " (inconclusive)" : ""),
                     failure_of(row)});
  return junit_document("fretval check " + run.name, cases);
}

}  // namespace fretval
