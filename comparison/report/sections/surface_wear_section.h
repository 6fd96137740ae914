#pragma once

#include <vector>

#include "comparison/report/text/filling.h"
#include "comparison/results/results_folder.h"

namespace fretval {

/// Indenters that wear off their circle under friction as a vector: what sticks in the end beside MDR's limit, the
/// course of the wear, and worn profiles in four directions. Null if there are none.
Filling surface_wear_section(const std::vector<StoredResult>& results);

}  // namespace fretval
