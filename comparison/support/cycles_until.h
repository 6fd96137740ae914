#pragma once

#include <optional>
#include <vector>

namespace fretval {

/// Mean slip in a cycle, over the tangential amplitude, below which a zone counts as shaken down; the same as for a
/// ring that counts as stuck (fem::slip_of_stuck_ring).
constexpr double slip_that_counts_as_none = 1e-4;

/// After how many cycles slip has died out: the time, in cycles from the beginning of the first one, at which straight
/// lines between the slips of cycles n = 1, 2, ... cross `least` for the last time. Empty: the slip is never above it,
/// or still is.
std::optional<double> cycles_until(const std::vector<double>& slips, double least);

}  // namespace fretval
