#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "comparison/verification/suite.h"

namespace fretval {

/// An object with `suite` and `about` (see SuiteRun), `summary` (pass, cases, agree, refused, inconclusive, fail,
/// errors, above_bar, computations, seconds), `quantities`, an array (quantity, tolerance, errors, above_bar, wide, and
/// median and high, 90 %, of error, bar and effectivity), and `rows`, the shown_rows: family, name, verdict, remark,
/// refusal, expected_refusal, quantities (by name: mdr, fe, error, tolerance, bar, source), worst (the quantity closest
/// to its bar), seconds, refinements, computations, case_file (its text). Null stands for missing values and for
/// numbers that are not finite.
nlohmann::ordered_json suite_json(const SuiteRun& run);

/// JUnit XML of all rows; an inconclusive row passes, and says so by its name.
std::string suite_junit(const SuiteRun& run);

}  // namespace fretval
