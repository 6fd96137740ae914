#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "comparison/support/json.h"
#include "comparison/support/junit.h"
#include "comparison/support/statistics.h"
#include "comparison/verification/suite.h"

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

constexpr std::size_t most_shown = 200, n_worst = 10;

void add(const ComparedQuantity& q, QuantitySummary& summary) {
  ++summary.n;
  if (q.share() > 1) ++summary.n_above;
  if (q.has_wide_bar()) ++summary.n_wide;
  const double error = std::abs(q.error());
  if (!std::isfinite(error)) return;
  summary.errors.push_back(error);
  if (!q.bar || !std::isfinite(*q.bar)) return;
  summary.bars.push_back(*q.bar);
  if (error > 0) summary.effectivities.push_back(*q.bar / error);
}

double badness(const SuiteRow& row) {
  if (!failure_of(row).empty()) return std::numeric_limits<double>::infinity();
  const auto* worst = worst_of(row);
  return worst ? worst->second.share() : 0;
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

QuantitySummaries quantity_summaries(const std::vector<SuiteRow>& rows) {
  QuantitySummaries all;
  for (const auto& row : rows)
    for (const auto& [quantity, compared] : row.compared) add(compared, all[{quantity, compared.tolerance}]);
  return all;
}

std::size_t count(const std::vector<SuiteRow>& rows, RowVerdict verdict) {
  return static_cast<std::size_t>(
      std::count_if(rows.begin(), rows.end(), [&](const SuiteRow& row) { return verdict_of(row) == verdict; }));
}

const ComparedQuantities::value_type* worst_of(const SuiteRow& row) {
  const auto found = std::max_element(row.compared.begin(), row.compared.end(),
                                      [](const auto& a, const auto& b) { return a.second.share() < b.second.share(); });
  return found == row.compared.end() ? nullptr : &*found;
}

std::vector<const SuiteRow*> shown_rows(const std::vector<SuiteRow>& rows) {
  if (rows.size() > most_shown) return worst_rows(rows);
  std::vector<const SuiteRow*> shown;
  for (const auto& row : rows) shown.push_back(&row);
  return shown;
}

std::vector<const SuiteRow*> worst_rows(const std::vector<SuiteRow>& rows) {
  std::vector<std::pair<double, const SuiteRow*>> order;
  for (const auto& row : rows) order.emplace_back(badness(row), &row);
  std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<const SuiteRow*> worst;
  for (const auto& [bad, row] : order)
    if (worst.size() < n_worst || std::isinf(bad)) worst.push_back(row);
  return worst;
}

std::string remark_of(const SuiteRow& row) {
  std::string failure = failure_of(row);
  if (!failure.empty()) return failure;
  if (!row.refusal.empty()) return row.refusal;
  std::string remark;
  for (const auto& [quantity, q] : row.compared)
    if (q.has_wide_bar())
      remark += fmt::format("{}{}: bar {:.1e}, mostly {}, tolerance {:.0e}", remark.empty() ? "" : "; ",
                            traits_of(quantity).title, *q.bar, q.source, q.tolerance);
  return remark;
}

}  // namespace fretval
