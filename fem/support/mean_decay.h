#pragma once

#include <cmath>

namespace fretval::fem {

/// Mean of `exp(-s)` for s from 0 to z: `(1 - exp(-z)) / z`, 1 at z = 0. z: not negative, may be infinite.
inline double mean_decay(double z) {
  return z == 0 ? 1 : -std::expm1(-z) / z;
}

}  // namespace fretval::fem
