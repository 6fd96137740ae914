#pragma once

#include <vector>

#include "comparison/verification/tolerance/tolerance_suite.h"

namespace fretval {

/// Fixed settings that a user might choose by hand, from 8 rings and 12 steps to 96 rings and 96 steps, without focus.
/// Settings that go with the time step (start, periodicity, creep) become finer with it. memory: see resolution_for.
std::vector<Resolution> grid_of_settings(bool memory = true);

/// Computes the cases at all settings, and at those that their records came to (Economised), in one run. Gives to each
/// of their records the seconds of its own, and the cheapest setting of the grid whose true errors meet the tolerance.
void search_grid(const std::vector<PreparedCase>& cases, const std::vector<MdrAnswer>& exact,
                 std::vector<ToleranceRecord>& records);

}  // namespace fretval
