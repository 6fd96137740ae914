#pragma once

#include <vector>

#include "comparison/report/text/filling.h"
#include "comparison/results/results_folder.h"

namespace fretval {

/// Indenters that wear: where finite elements end and where MDR says that they do, and the course of one case of each
/// family. Null if no result has any wear.
Filling wear_section(const std::vector<StoredResult>& results);

}  // namespace fretval
