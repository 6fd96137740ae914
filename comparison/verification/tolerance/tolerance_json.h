#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "comparison/verification/tolerance/tolerance_suite.h"

namespace fretval {

/// An object with `summary`, an array with an object a tolerance (tolerance, cases, meet, errors, covered,
/// median_effectivity, high_effectivity, median_cost_ratio, largest_cost_ratio, searched, not_in_grid, inconclusive),
/// and `records`, an array with an object a case and tolerance: name, tolerance, failure, pass, errors (by quantity:
/// error, tolerance, bar, covered, meets, finding, shares by source), resolution, focus, refinements, computations,
/// seconds, economised (resolutions, errors, seconds), searched, cheapest (of the grid: resolution, seconds, ratio).
/// Null: what there is none of, and numbers that are not finite.
nlohmann::ordered_json tolerance_json(const std::vector<ToleranceRecord>& records);

}  // namespace fretval
