#pragma once

#include "fem/operators/grid_data.h"

namespace fretval::fem {

/// The grid with every cell split into four at the midpoints of its edges and its centre. The body stays the same,
/// straight edges included.
GridData refined(const GridData& grid);

}  // namespace fretval::fem
