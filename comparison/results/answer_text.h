#pragma once

#include <string>

#include "comparison/results/case_result.h"

namespace fretval {

/// A value in SI units for people: with the prefix that leaves one to three digits before the point, and as many digits
/// as its error bar allows, or six: "0.79312 ± 0.00004 mm". bar: absolute; 0: none is known. unit: "m", "N", ….
std::string with_unit(double value, double bar, const std::string& unit);

/// The answer to a case for the terminal: the verdict in a sentence, then each quantity by finite elements, with its
/// error bar, and by MDR.
std::string answer_text(const CaseResult& result);

}  // namespace fretval
