#pragma once

#include <optional>
#include <vector>

#include "comparison/verification/suite.h"

namespace fretval {

/// Resident memory after a number of cases.
struct MemorySample {
  std::size_t n_cases;
  double bytes;
};

/// Resident memory from the second quarter of a run, when everything that is made once is there, to the last one: the
/// medians of both, so that a single batch does not decide.
struct MemoryGrowth {
  double start, end;    ///< bytes
  std::size_t n_cases;  ///< from the middle of the one quarter to the middle of the other

  [[nodiscard]] double bytes_per_case() const;
  /// At most 16 MB more at the end; the rows of ten thousand cases are some 5 MB of that.
  [[nodiscard]] bool is_flat() const;
};

/// Empty for less than eight samples, which tell nothing.
std::optional<MemoryGrowth> memory_growth(const std::vector<MemorySample>& samples);

/// That the memory is flat, or that there are too few samples to judge.
SuiteCheck memory_check(const std::vector<MemorySample>& samples);

}  // namespace fretval
