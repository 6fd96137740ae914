#pragma once

#include <string>
#include <vector>

#include "comparison/results/results_folder.h"

namespace fretval {

/// Indenters that wear: where finite elements end and where MDR says that they do, and the course of one case of each
/// family. Empty if no result has any wear.
std::string wear_section(const std::vector<StoredResult>& results);

}  // namespace fretval
