#pragma once

#include <string>

#include "comparison/verification/random_cases/random_summary.h"

namespace fretval {

/// A line a quantity with the distributions of errors, bars and effectivity; memory; the ten worst cases; the verdict.
std::string soak_table(const SoakRun& run, const SoakSummary& summary);

/// JUnit XML: that no case fails, that each quantity is within its bars, that the memory is flat.
std::string soak_junit(const SoakSummary& summary);

/// "in 10000 cases 0 failures, 3 of 39000 errors are above their bar, memory flat"
std::string verdict_text(const SoakSummary& summary);

}  // namespace fretval
