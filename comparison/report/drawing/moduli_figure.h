#pragma once

#include "comparison/report/drawing/figures.h"
#include "comparison/results/results_folder.h"

namespace fretval {

/// Storage and loss modulus of the body over frequency, from moduli.csv; of measured moduli the points, and how well
/// the body stands for them.
Figure moduli_figure(const StoredResult& result);

}  // namespace fretval
