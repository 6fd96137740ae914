#pragma once

#include "comparison/report/drawing/figures.h"
#include "comparison/results/results_folder.h"

namespace fretval {

/// Storage and loss modulus of the body over frequency, from moduli.csv; with the points of measured moduli, and how
/// well the body fits them.
Figure moduli_figure(const StoredResult& result);

}  // namespace fretval
