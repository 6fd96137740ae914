#pragma once

#include <vector>

#include "comparison/report/text/filling.h"
#include "comparison/results/results_folder.h"

namespace fretval {

/// The cases that are no points of a sweep, each with its answer, the scene and its plots. Null if there is none.
Filling cases_section(const std::vector<StoredResult>& results);

}  // namespace fretval
