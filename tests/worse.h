#pragma once

#include <cmath>

namespace fretval {

/// The larger of two errors, not a number if one is not. std::max(worst, error) drops an error that is not a number,
/// and whatever is asked of the worst one holds.
inline double worse(double worst, double error) {
  return std::isnan(worst) || error <= worst ? worst : error;
}

}  // namespace fretval
