#pragma once

#include <vector>

#include "comparison/verification/extremes/extreme_rows.h"
#include "comparison/verification/suite.h"

namespace fretval {

/// The rows as cases of a suite.
std::vector<SuiteCase> extreme_cases(const std::vector<ExtremeRow>& rows);

SuiteRun run_extreme_suite(const std::vector<ExtremeRow>& rows);

}  // namespace fretval
