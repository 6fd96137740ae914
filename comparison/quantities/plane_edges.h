#pragma once

#include <vector>

namespace fretval {

/// Edges of the zones of a contact over the angle around its centre, m.
struct PlaneEdges {
  std::vector<double> angle;  ///< rad, around the whole circle
  std::vector<double> contact, never_slipped;
  std::vector<double> sticks_in_a_cycle;  ///< empty: of a single pass
};

}  // namespace fretval
