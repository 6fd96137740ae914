#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "comparison/report/text/render.h"
#include "comparison/results/results_folder.h"

namespace fretval {

/// What the comparisons of a quantity come to over the results. Covered: the difference is within the error bar.
struct Extreme {
  double difference = 0, tolerance = 0, largest_bar = 0;
  std::string name;
  std::size_t n_compared = 0, n_pass = 0, n_inconclusive = 0, n_with_bar = 0, n_covered = 0;
};

/// key: of a quantity in result.json.
Extreme extreme_of(const std::vector<StoredResult>& results, const char* key);

/// How many cases agree, and the largest difference and error bar of each quantity.
Filling verdict_section(const std::vector<StoredResult>& results);

/// Which sources make up the error bars, median and largest over the results. Null if none was measured.
Filling budget_section(const std::vector<StoredResult>& results);

}  // namespace fretval
