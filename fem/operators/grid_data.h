#pragma once

#include <array>
#include <vector>

namespace fretval::fem {

/// Parts of the boundary of the meridian half-plane.
enum class BoundaryPart { axis = 1, contact = 2, free = 3, far = 4 };

/// A quadrilateral grid of the (r, z) half-plane as plain data; the body fills z <= 0.
struct GridData {
  struct BoundaryEdge {
    std::array<unsigned, 2> points;
    BoundaryPart part;
  };
  std::vector<std::array<double, 2>> points;   ///< (r, z)
  std::vector<std::array<unsigned, 4>> cells;  ///< counter-clockwise corner indices
  std::vector<BoundaryEdge> boundary;
};

}  // namespace fretval::fem
