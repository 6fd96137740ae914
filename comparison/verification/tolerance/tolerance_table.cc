#include "comparison/verification/tolerance/tolerance_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "comparison/support/junit.h"
#include "comparison/support/quantile.h"

namespace fretval {
namespace {

ToleranceSummary summary_of(double tolerance, const std::vector<ToleranceRecord>& records) {
  ToleranceSummary summary;
  summary.tolerance = tolerance;
  std::vector<double> effectivities, ratios;
  for (const auto& record : records) {
    if (record.tolerance != tolerance) continue;
    ++summary.n_cases;
    if (record.failure.empty() && record.meets()) ++summary.n_meet;
    for (const auto* errors : {&record.errors, &record.economised.errors})
      for (const auto& [quantity, e] : *errors) {
        ++summary.n_errors;
        if (e.covered()) ++summary.n_covered;
        if (e.error != 0) effectivities.push_back(e.bar / std::abs(e.error));
      }
    if (record.inconclusive()) summary.inconclusive.push_back(record.name);
    if (!record.in_grid) continue;
    ++summary.n_searched;
    if (const auto ratio = cost_ratio(record))
      ratios.push_back(*ratio);
    else
      ++summary.n_not_in_grid;
  }
  summary.median_effectivity = quantile(effectivities, 0.5);
  summary.high_effectivity = quantile(effectivities, 0.9);
  summary.median_cost_ratio = quantile(ratios, 0.5);
  summary.largest_cost_ratio = quantile(ratios, 1);
  return summary;
}

std::string number(const std::optional<double>& value) {
  return value ? fmt::format("{:.3g}", *value) : "none";
}

std::string remarks_of(const ToleranceRecord& record) {
  if (!record.failure.empty()) return record.failure;
  std::vector<std::string> remarks;
  if (!record.meets()) remarks.emplace_back("MISSES");
  if (!record.covered()) remarks.emplace_back("NOT COVERED");
  if (record.inconclusive()) remarks.emplace_back("inconclusive");
  return fmt::format("{}", fmt::join(remarks, ", "));
}

std::string share_text(const ToleranceRecord& record, const std::string& quantity) {
  const auto found = record.budget.find(quantity);
  const ErrorShare* largest = found == record.budget.end() ? nullptr : found->second.largest();
  if (!largest) return "";
  return fmt::format(", mostly {} {:.1e}", name_of(largest->source), largest->estimate);
}

std::string paragraph_of(const ToleranceRecord& record) {
  std::string text = fmt::format("{} at {:.0e}: {}\n  {}, {} refinements, {:.2f} s\n", record.name, record.tolerance,
                                 remarks_of(record), text_of(record.resolution), record.n_refinements, record.seconds);
  for (const auto& [quantity, f] : record.focus)
    text += fmt::format("  focus of {}: rings of {:.2g} from {:.6g} to {:.6g}\n", quantity, f.ring, f.inner, f.outer);
  const auto list = [&](const TrueErrors& errors, const auto& remark) {
    for (const auto& [quantity, e] : errors)
      if (!e.meets() || !e.covered() || e.finding() == Verdict::inconclusive)
        text += fmt::format("  {:<24} error {:9.2e}, bar {:8.2e}, tolerance {:.0e}: {}{}\n", quantity, e.error, e.bar,
                            e.tolerance, name_of(e.finding()), remark(quantity));
  };
  list(record.errors, [&](const std::string& quantity) { return share_text(record, quantity); });
  list(record.economised.errors, [](const std::string&) { return ", economised"; });
  return text;
}

}  // namespace

std::optional<double> cost_ratio(const ToleranceRecord& record) {
  if (!record.cheapest) return std::nullopt;
  return record.economised.seconds / record.cheapest->seconds;
}

std::vector<ToleranceSummary> summaries(const std::vector<ToleranceRecord>& records) {
  std::vector<ToleranceSummary> all;
  for (const auto& record : records) {
    const auto is_there = [&](const ToleranceSummary& s) { return s.tolerance == record.tolerance; };
    if (std::none_of(all.begin(), all.end(), is_there)) all.push_back(summary_of(record.tolerance, records));
  }
  return all;
}

std::string tolerance_table(const std::vector<ToleranceRecord>& records) {
  std::string text =
      fmt::format("{:<10} {:>9} {:>9} {:>17} {:>9} {:>16} {:>9} {:>12} {}\n", "tolerance", "met", "covered",
                  "effectivity, med.", "90 %", "cost ratio, med.", "largest", "not in grid", "inconclusive");
  for (const auto& s : summaries(records))
    text += fmt::format("{:<10.0e} {:>9} {:>9} {:>17} {:>9} {:>16} {:>9} {:>12} {}\n", s.tolerance,
                        fmt::format("{}/{}", s.n_meet, s.n_cases), fmt::format("{}/{}", s.n_covered, s.n_errors),
                        number(s.median_effectivity), number(s.high_effectivity), number(s.median_cost_ratio),
                        number(s.largest_cost_ratio), fmt::format("{}/{}", s.n_not_in_grid, s.n_searched),
                        s.inconclusive.empty() ? "none" : fmt::format("{}", fmt::join(s.inconclusive, ", ")));
  for (const auto& record : records)
    if (!record.passes() || record.inconclusive()) text += paragraph_of(record);
  return text;
}

std::string tolerance_junit(const std::vector<ToleranceRecord>& records) {
  std::vector<JUnitCase> cases;
  cases.reserve(records.size());
  for (const auto& record : records)
    cases.push_back(
        {fmt::format("{} at {:.0e}", record.name, record.tolerance), record.passes() ? "" : remarks_of(record)});
  return junit_document("fretval check tolerance", cases);
}

}  // namespace fretval
