#include "comparison/verification/extremes/extremes_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparison/support/junit.h"

namespace fretval {
namespace {

/// "0.54321 0.54322": MDR, finite elements.
std::string pair_text(const ExtremeRecord& record, const std::string& quantity) {
  const auto found = record.errors.find(quantity);
  if (found == record.errors.end()) return fmt::format("{:>9} {:>9}", "-", "-");
  return fmt::format("{:9.6f} {:9.6f}", found->second.mdr, found->second.fe);
}

std::string line_of(const ExtremeRecord& record, std::size_t value_width) {
  std::string worst = fmt::format("{:>30}", "");
  if (const auto* w = worst_of(record))
    worst = fmt::format("{:9.1e} {:8.1e} {:9.0e}", w->second.error, w->second.bar, w->second.tolerance);
  return fmt::format("  {:<12} {:<{}} {} {} {:<28} {:6.2f} {}\n", name_of(verdict_of(record)), record.row.value,
                     value_width, pair_text(record, "stick_radius_first_slip"),
                     pair_text(record, "stick_radius_shakedown"), worst, record.seconds, remark_of(record));
}

}  // namespace

const std::pair<const std::string, ExtremeError>* worst_of(const ExtremeRecord& record) {
  const auto share = [](const ExtremeError& e) { return std::max(std::abs(e.error), e.bar) / e.tolerance; };
  const auto found = std::max_element(record.errors.begin(), record.errors.end(),
                                      [&](const auto& a, const auto& b) { return share(a.second) < share(b.second); });
  return found == record.errors.end() ? nullptr : &*found;
}

std::string remark_of(const ExtremeRecord& record) {
  std::string failure = failure_of(record);
  if (!failure.empty()) return failure;
  if (!record.refusal.empty()) return record.refusal;
  if (verdict_of(record) != ExtremeVerdict::inconclusive) return "";
  std::string remark;
  for (const auto& [quantity, e] : record.errors)
    if (e.bar > e.tolerance)
      remark += fmt::format("{}{}: bar {:.1e}, mostly {}, tolerance {:.0e}", remark.empty() ? "" : "; ", quantity,
                            e.bar, e.source, e.tolerance);
  return remark;
}

std::string counts_text(const std::vector<ExtremeRecord>& records) {
  return fmt::format("{} scenes: {} agree, {} refused as expected, {} inconclusive, {} FAIL", records.size(),
                     count(records, ExtremeVerdict::agrees), count(records, ExtremeVerdict::refused),
                     count(records, ExtremeVerdict::inconclusive), count(records, ExtremeVerdict::fails));
}

std::string extremes_table(const std::vector<ExtremeRecord>& records) {
  std::size_t value_width = 0;
  for (const auto& record : records) value_width = std::max(value_width, record.row.value.size());
  std::string text = fmt::format("  {:<12} {:<{}} {:>19} {:>19} {:>9} {:>8} {:>9} {:>6}\n", "", "", value_width,
                                 "c_first: MDR, FE", "c_shake: MDR, FE", "error", "bar", "tolerance", "s");
  const std::string* family = nullptr;
  for (const auto& record : records) {
    if (!family || *family != record.row.family) text += record.row.family + "\n";
    family = &record.row.family;
    text += line_of(record, value_width);
  }
  return text + counts_text(records) + "\n";
}

std::string extremes_junit(const std::vector<ExtremeRecord>& records) {
  std::vector<JUnitCase> cases;
  cases.reserve(records.size());
  for (const auto& record : records)
    cases.push_back({fmt::format("{}: {}{}", record.row.family, record.row.value,
                                 verdict_of(record) == ExtremeVerdict::inconclusive ? " (inconclusive)" : ""),
                     failure_of(record)});
  return junit_document("fretval check extremes", cases);
}

}  // namespace fretval
