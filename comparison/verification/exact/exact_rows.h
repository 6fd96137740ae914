#pragma once

#include <vector>

#include "comparison/verification/exact/convergence_rows.h"

namespace fretval {

/// Every row, on 16, 32, 64 and 128 rings per contact radius.
std::vector<ConvergenceRow> exact_rows();

}  // namespace fretval
