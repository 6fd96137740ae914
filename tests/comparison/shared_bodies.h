#pragma once

#include "comparison/simulation/bodies/body_store.h"

namespace fretval {

/// The bodies of all tests of something else, each made once.
inline BodyStore& shared_bodies() {
  static BodyStore bodies;
  return bodies;
}

}  // namespace fretval
