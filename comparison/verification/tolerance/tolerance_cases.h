#pragma once

#include <string>
#include <utility>
#include <vector>

#include "comparison/verification/written_case.h"

namespace fretval {

/// Fifty varied cases on which the suite `tolerance` measures whether `Accuracy / Tolerance` is met: all shapes with
/// a formula, elastic to three branches, Kelvin-Voigt bodies up to omega tau = 2, locked and unlocked phases, stick
/// zones down to 0.02 a, slip annuli down to 1e-3 a, no first-slip zone, no tangential motion. The stick radius of a
/// truncated sphere is away from the edge of its flat. They were chosen before their errors were known.
std::vector<Case> tolerance_cases(double tolerance);

/// The same as entries of case files, with their names.
std::vector<std::pair<std::string, Entries>> tolerance_entries(double tolerance);

}  // namespace fretval
