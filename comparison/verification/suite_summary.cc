#include "comparison/verification/suite_summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fretval {
namespace {

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
