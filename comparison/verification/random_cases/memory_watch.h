#pragma once

#include <vector>

#include "comparison/verification/suite.h"

namespace fretval {

/// Resident memory after a number of cases.
struct MemorySample {
  std::size_t n_cases;
  double bytes;
};

/// That the resident memory does not grow by more than 16 MB, of which the rows of ten thousand cases take some 5: from
/// the second quarter of a run, when everything that is made once is there, to the last one. Medians of both, so that a
/// single sample does not decide. Less than eight samples tell nothing.
SuiteCheck memory_check(const std::vector<MemorySample>& samples);

}  // namespace fretval
