#include "comparison/verification/suite_table.h"

#include <fmt/format.h>

#include <algorithm>

#include "comparison/support/junit.h"
#include "comparison/verification/suite_summary.h"

namespace fretval {
namespace {

std::string number(const std::optional<double>& value, const char* format = "{:.1e}") {
  return value ? fmt::format(fmt::runtime(format), *value) : "-";
}

std::string line_of(const SuiteRow& row, const std::string& name, std::size_t name_width) {
  std::string numbers = fmt::format("{:<24} {:>10} {:>10} {:>9} {:>8} {:>9}", "-", "-", "-", "-", "-", "-");
  if (const auto* worst = worst_of(row)) {
    const auto& q = worst->second;
    numbers = fmt::format("{:<24} {:>10.6f} {:>10.6f} {:>9.1e} {:>8} {:>9.1e}", name_of(worst->first), q.mdr, q.fe,
                          q.error(), number(q.bar), q.tolerance);
  }
  const auto remark = remark_of(row);
  return fmt::format("  {:<12} {:<{}} {} {:>6.2f}{}{}\n", name_of(verdict_of(row)), name, name_width, numbers,
                     row.seconds, remark.empty() ? "" : "  ", remark);
}

/// Whether the rows come by families of several members.
bool are_families(const std::vector<const SuiteRow*>& rows) {
  std::size_t n_families = 0;
  for (std::size_t i = 0; i < rows.size(); ++i)
    n_families += i == 0 || rows[i]->asked.family != rows[i - 1]->asked.family ? 1 : 0;
  return 2 * n_families <= rows.size();
}

std::string rows_text(const SuiteRun& run) {
  const auto rows = shown_rows(run.rows);
  const bool by_families = shows_all(run.rows) && are_families(rows);
  const auto name = [&](const SuiteRow& row) { return by_families ? row.asked.name : title_of(row.asked); };
  std::size_t width = 0;
  for (const auto* row : rows) width = std::max(width, name(*row).size());
  std::string text = shows_all(run.rows) ? "" : fmt::format("  the worst of {}\n", run.rows.size());
  text += fmt::format("  {:<12} {:<{}} {:<24} {:>10} {:>10} {:>9} {:>8} {:>9} {:>6}\n", "", "", width,
                      "closest to its limit", "MDR", "FE", "error", "bar", "tolerance", "s");
  const std::string* family = nullptr;
  for (const auto* row : rows) {
    if (by_families && (!family || *family != row->asked.family)) text += row->asked.family + "\n";
    family = &row->asked.family;
    text += line_of(*row, name(*row), width);
  }
  return text;
}

std::string line_of(const QuantitySummary& s) {
  return fmt::format("  {:<24} {:>9.1e} {:>6} {:>9} {:>6} {:>9} {:>9} {:>9} {:>9} {:>9} {:>8} {:>8} {:>8}\n",
                     name_of(s.quantity), s.tolerance, s.n, s.n_above, s.n_wide, s.n_unbounded, number(s.error.median),
                     number(s.error.high), number(s.bar.median), number(s.bar.high),
                     number(s.effectivity.low, "{:.3g}"), number(s.effectivity.median, "{:.3g}"),
                     number(s.effectivity.high, "{:.3g}"));
}

}  // namespace

std::string suite_table(const SuiteRun& run) {
  std::string text = rows_text(run);
  text += fmt::format("  {:<24} {:>9} {:>6} {:>9} {:>6} {:>9} {:>9} {:>9} {:>9} {:>9} {:>8} {:>8} {:>8}\n",
                      "all together", "tolerance", "errors", "above bar", "wide", "unbounded", "error 50%", "90%",
                      "bar 50%", "90%", "eff. 10%", "50%", "90%");
  for (const auto& summary : quantity_summaries(run.rows)) text += line_of(summary);
  for (const auto& check : run.checks)
    text += fmt::format("{}: {}{}\n", check.name, check.finding, check.failure.empty() ? "" : ": " + check.failure);
  return text + fmt::format("{}: {}\n", run.passes() ? "pass" : "FAIL", counts_text(run.rows));
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
