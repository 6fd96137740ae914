#pragma once

#include <limits>
#include <string>

#include "comparison/verification/suite.h"

namespace fretval {

inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// A row with one quantity, whose tolerance is 1e-2.
inline SuiteRow row_of(double error, std::optional<double> bar, const std::string& name = "value") {
  SuiteRow row;
  row.asked.family = "family";
  row.asked.name = name;
  row.asked.text = "text of " + name;
  row.compared[Quantity::stick_radius_shakedown] = {0.6, 0.6 + error, 1e-2, bar, "rings"};
  return row;
}

inline SuiteRow refused_row(const std::string& expected, const std::string& message) {
  SuiteRow row;
  row.asked.name = "refused";
  row.asked.refusal = expected;
  row.refusal = message;
  return row;
}

inline SuiteRun run_of(std::vector<SuiteRow> rows) {
  return {"extremes", "About <it>.", std::move(rows)};
}

/// Two rows that agree or may, one that fails, one that is refused.
inline SuiteRun mixed_run() {
  return run_of(
      {row_of(1e-3, 2e-3, "good"), row_of(1e-3, 2e-2, "wide"), row_of(3e-2, 2e-3, "<bad>"), refused_row("a", "a b")});
}

/// What there is to be said of its rows.
inline std::string remarks_of(const SuiteRun& run) {
  std::string text;
  for (const auto& row : run.rows)
    if (const auto remark = remark_of(row); !remark.empty()) text += title_of(row.asked) + ": " + remark + "\n";
  return text;
}

}  // namespace fretval
