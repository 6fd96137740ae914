#pragma once

#include <vector>

namespace fretval::fem {

/// Widths of the rings inside and outside of one of their radii; 0 where there is no ring.
struct RingWidths {
  double inside, outside;
};
RingWidths rings_at(const std::vector<double>& radii, double radius);

}  // namespace fretval::fem
