#include "comparison/verification/random_cases/random_table.h"

#include <fmt/format.h>

#include "comparison/support/junit.h"

namespace fretval {
namespace {

std::string number(const std::optional<double>& value) {
  return value ? fmt::format("{:.1e}", *value) : "-";
}

std::string line_of(const SoakDistribution& d) {
  return fmt::format("  {:<24} {:>6} {:>9} {:>9} {:>9} {:>9} {:>9} {:>8.1f} {:>8.1f} {:>9} {:>8} {:>8}\n", d.quantity,
                     d.n, d.n - d.n_covered, number(d.median_error), number(d.high_error), number(d.median_bar),
                     number(d.high_bar), 100 * d.wide, 100 * d.very_wide, d.n_unbounded, number(d.low_effectivity),
                     number(d.median_effectivity));
}

std::string worst_line(const SoakRecord& record) {
  const auto worst = record.worst();
  if (!worst || !record.failure.empty())
    return fmt::format("  {:>6} {} [{}]\n", record.draw.number, failure_of(record), scene_text(record));
  const auto& e = *record.errors[*worst];
  return fmt::format("  {:>6} {:<24} {:>10.6f} {:>10.6f} {:>9.1e} {:>8.1e} {:>6.2f} {:<13} {}\n", record.draw.number,
                     soak_quantities[*worst], e.mdr, e.fe, e.error(), e.bar, e.share(), name_of(e.source),
                     scene_text(record));
}

std::string memory_text(const std::optional<MemoryGrowth>& memory) {
  if (!memory) return "memory: too few cases to judge";
  return fmt::format("memory: {:.1f} MB in the second quarter, {:.1f} MB in the last, {:.0f} bytes per case: {}",
                     memory->start / 1e6, memory->end / 1e6, memory->bytes_per_case(),
                     memory->is_flat() ? "flat" : "GROWS");
}

}  // namespace

std::string verdict_text(const SoakSummary& s) {
  return fmt::format("in {} cases {} failures, {} of {} errors are above their bar, {}", s.n_cases, s.n_failures,
                     s.n_above_bar, s.n_comparisons,
                     s.memory ? (s.memory->is_flat() ? "memory flat" : "memory GROWS") : "memory not judged");
}

std::string soak_table(const SoakRun& run, const SoakSummary& summary) {
  std::string text =
      fmt::format("  {:<24} {:>6} {:>9} {:>9} {:>9} {:>9} {:>9} {:>8} {:>8} {:>9} {:>8} {:>8}\n", "", "", "above bar",
                  "error 50%", "90%", "bar 50%", "90%", "% > 1e-2", "% > 1e-1", "unbounded", "eff. 10%", "50%");
  for (const auto& distribution : summary.distributions)
    if (distribution.n > 0) text += line_of(distribution);
  text += memory_text(summary.memory) + "\n";
  text += fmt::format("the worst of all\n  {:>6} {:<24} {:>10} {:>10} {:>9} {:>8} {:>6} {:<13} scene\n", "number",
                      "quantity", "MDR", "FE", "error", "bar", "share", "mostly");
  for (const auto* record : summary.worst) text += worst_line(*record);
  return text + fmt::format("{} friction histories in {:.1f} s; {} cases were drawn again\n{}: {}\n", run.n_histories,
                            run.seconds, summary.n_drawn_again, summary.passes() ? "pass" : "FAIL",
                            verdict_text(summary));
}

std::string soak_junit(const SoakSummary& summary) {
  std::vector<JUnitCase> cases{
      {"no case fails", summary.n_failures == 0 ? "" : fmt::format("{} cases fail", summary.n_failures)}};
  for (const auto& d : summary.distributions)
    cases.push_back({d.quantity + " within its bars",
                     d.n == d.n_covered ? "" : fmt::format("{} of {} errors are above", d.n - d.n_covered, d.n)});
  cases.push_back({"memory is flat", !summary.memory || summary.memory->is_flat() ? "" : memory_text(summary.memory)});
  return junit_document("fretval check soak", cases);
}

}  // namespace fretval
