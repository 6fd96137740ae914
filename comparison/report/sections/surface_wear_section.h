#pragma once

#include <vector>

#include "comparison/report/text/filling.h"
#include "comparison/results/results_folder.h"

namespace fretval {

/// Section about indenters that wear under friction as a vector, to shapes that are not axisymmetric: the zone that
/// sticks in the end beside MDR's limit, the course of the wear, and worn profiles in four directions. Null if there
/// are none.
Filling surface_wear_section(const std::vector<StoredResult>& results);

}  // namespace fretval
