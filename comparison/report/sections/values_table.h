#pragma once

#include <vector>

#include "comparison/quantities/quantity.h"
#include "comparison/report/text/table.h"
#include "comparison/results/results_folder.h"

namespace fretval {

/// What both methods say, before how they differ: the values of each case, or from the least to the largest of a sweep,
/// with units, those of the finite elements with their bars. Of few families a row a quantity, of many a row a family
/// with stick radii alone.
Table values_table(const std::vector<StoredResult>& results, const std::vector<Quantity>& quantities);

/// A row for each value of a sweep, or each pair of a map: stick radii by both methods, or where nothing sticks contact
/// radius and normal force, and the verdict. family: of one sweep.
Table sweep_rows(const std::vector<StoredResult>& family);

/// What a terminal has room for.
const std::vector<Quantity>& main_quantities();

/// All that have a unit.
const std::vector<Quantity>& quantities_with_units();

}  // namespace fretval
