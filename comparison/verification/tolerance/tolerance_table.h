#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparison/verification/tolerance/tolerance_suite.h"

namespace fretval {

/// What the records of one tolerance come to. Errors: of the proved answers and of the economised ones. Effectivity:
/// error bar over true error, of all quantities whose error is not zero. Cost ratio: seconds of the economised setting
/// over those of the cheapest of the grid that meets the tolerance.
struct ToleranceSummary {
  double tolerance = 0;
  std::size_t n_cases = 0, n_meet = 0, n_errors = 0, n_covered = 0;
  std::optional<double> median_effectivity, high_effectivity;  ///< high: 90 % are below
  std::optional<double> median_cost_ratio, largest_cost_ratio;
  std::size_t n_searched = 0, n_not_in_grid = 0;  ///< cases in the grid, and those that no setting of it meets
  std::vector<std::string> inconclusive;
};

/// One for each tolerance, in the order in which they come.
std::vector<ToleranceSummary> summaries(const std::vector<ToleranceRecord>& records);

/// Empty: the chosen cost is not compared, or nothing in the grid meets the tolerance.
std::optional<double> cost_ratio(const ToleranceRecord& record);

/// The summaries, and a paragraph about every record that misses, is not covered or is inconclusive.
std::string tolerance_table(const std::vector<ToleranceRecord>& records);

/// JUnit XML of the records.
std::string tolerance_junit(const std::vector<ToleranceRecord>& records);

}  // namespace fretval
