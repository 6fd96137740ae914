#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "comparison/verification/exact/convergence_rows.h"

namespace fretval {

/// An array with an object a row: solution, quantity, source, refined, resolutions, errors, observed_order,
/// expected_order, tolerance, goal, goal_met, verdict ("pass" or why it fails), note. Null: observed_order with all
/// errors at the floor, goal and goal_met without a goal, and errors that are not finite.
nlohmann::ordered_json convergence_json(const std::vector<ConvergenceRow>& rows);

}  // namespace fretval
