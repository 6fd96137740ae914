#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "comparison/accuracy/verdict.h"
#include "comparison/report/text/filling.h"
#include "comparison/results/results_folder.h"

namespace fretval {

/// Summary of the comparisons of a quantity over the results: the largest difference, with the bar (of both methods
/// together) and the tolerance of its case.
struct Extreme {
  double size = 0, tolerance = 0, bar = 0;
  std::string name;
  std::size_t n_compared = 0, n_asked = 0;
  std::map<Verdict, std::size_t> counts = {};
};
Extreme extreme_of(const std::vector<StoredResult>& results, Quantity quantity);

/// How many cases agree, and the largest difference and error bar of each quantity.
Filling verdict_section(const std::vector<StoredResult>& results);

/// Which sources make up the error bars, median and largest over the results. Null if none was measured.
Filling budget_section(const std::vector<StoredResult>& results);

}  // namespace fretval
