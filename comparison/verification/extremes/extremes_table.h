#pragma once

#include <string>
#include <utility>
#include <vector>

#include "comparison/verification/extremes/extremes.h"

namespace fretval {

/// What is to be said of a scene besides its numbers: why it fails, the message it is refused with, or which bar is
/// wider than its tolerance.
std::string remark_of(const ExtremeRecord& record);

/// A heading and a line a scene by families: verdict, both stick radii of MDR and of the finite elements, the largest
/// error over its tolerance with its bar, seconds, remark; at the end the counts of the verdicts.
std::string extremes_table(const std::vector<ExtremeRecord>& records);

/// JUnit XML of the scenes; an inconclusive one passes, and says so by its name.
std::string extremes_junit(const std::vector<ExtremeRecord>& records);

/// The quantity whose error takes the largest share of its tolerance, or of its bar where that is wider; null: nothing
/// was compared.
const std::pair<const std::string, ExtremeError>* worst_of(const ExtremeRecord& record);

/// "150 agree, 12 refused as expected, 3 inconclusive, 0 FAIL"
std::string counts_text(const std::vector<ExtremeRecord>& records);

}  // namespace fretval
