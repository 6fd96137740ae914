#pragma once

#include <vector>

#include "comparison/verification/suite.h"

namespace fretval {

/// Fifty varied cases on which the suite `tolerance` measures whether `Accuracy / Tolerance` is met, and proved: all
/// shapes with a formula, elastic to three branches, Kelvin-Voigt bodies up to omega tau = 2, locked and unlocked
/// phases, stick zones down to 0.02 a, slip annuli down to 1e-3 a, no first-slip zone, no tangential motion. The stick
/// radius of a truncated sphere is away from the edge of its flat. They were chosen before their errors were known.
std::vector<SuiteCase> tolerance_cases(double tolerance);

/// Runs the suite: all tolerance_cases() at each tolerance.
SuiteRun run_tolerance_suite(const std::vector<double>& tolerances);

}  // namespace fretval
