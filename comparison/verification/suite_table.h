#pragma once

#include <string>

#include "comparison/verification/suite.h"

namespace fretval {

/// A line per row by families, or the worst rows alone if there are many: verdict, the quantity with the largest share
/// of its bar as MDR and finite elements say it, error, bar, tolerance, seconds, remark. Then a line per quantity and
/// tolerance over all rows, the checks of the whole, the counts.
std::string suite_table(const SuiteRun& run);

/// JUnit XML of all rows and of the checks of the whole; an inconclusive row passes, and says so by its name.
std::string suite_junit(const SuiteRun& run);

}  // namespace fretval
