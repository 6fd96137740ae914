#pragma once

#include <vector>

#include "comparison/quantities/quantity.h"
#include "comparison/report/text/table.h"
#include "comparison/results/results_folder.h"

namespace fretval {

/// Table of the values by both methods, which stands before their differences: the values of each case, or the range
/// over a sweep, with units, and for finite elements with their bars. With few families there is a row for each
/// quantity, with many a row for each family, with the stick radii alone.
Table values_table(const std::vector<StoredResult>& results, const std::vector<Quantity>& quantities);

/// A row for each value of a sweep, or each pair of a map: stick radii by both methods, or contact radius and normal
/// force where nothing sticks, and the verdict. family: the results of one sweep.
Table sweep_rows(const std::vector<StoredResult>& family);

/// The quantities for which a terminal has room.
const std::vector<Quantity>& main_quantities();

/// All quantities that have a unit.
const std::vector<Quantity>& quantities_with_units();

}  // namespace fretval
