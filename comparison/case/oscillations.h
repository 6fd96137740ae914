#pragma once

#include <vector>

#include "comparison/case/case.h"

namespace fretval {

/// Every oscillation that a case prescribes, of a displacement in m or a force in N, in all directions; none along a
/// path. An amplitude may be 0, and NaN where it is to be found.
std::vector<Case::Harmonic> oscillations_of(const Case::Motion& motion);

/// Frequencies in Hz of those that move something; along a path that repeats, that of its period.
std::vector<double> moving_frequencies(const Case::Motion& motion);

}  // namespace fretval
