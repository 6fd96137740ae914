#pragma once

#include <vector>

#include "comparison/report/text/filling.h"
#include "comparison/results/results_folder.h"

namespace fretval {

/// Section about indenters that wear: where wear ends by finite elements and by MDR, and the course of one case of each
/// family. Null if no result has any wear.
Filling wear_section(const std::vector<StoredResult>& results);

}  // namespace fretval
