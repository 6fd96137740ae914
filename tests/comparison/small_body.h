#pragma once

#include "comparison/simulation/bodies/body.h"

namespace fretval {

/// Of a body that is made in milliseconds.
inline BodyDescription small_body(bool tangential = true) {
  return {{0, 0.25, 0.5, 0.75, 1}, 0.3, 10, 2, tangential};
}

}  // namespace fretval
