#pragma once

#include <vector>

#include "comparison/report/text/filling.h"
#include "comparison/results/results_folder.h"

namespace fretval {

/// How finite elements compute, and what all of it took: the first case at its chosen resolution, and the computations
/// of all proofs.
Filling cost_section(const std::vector<StoredResult>& results);

}  // namespace fretval
