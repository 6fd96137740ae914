#pragma once

#include <array>
#include <vector>

namespace fretval::fem {

/// Parts of the boundary of the meridian half-plane, and what holds there: symmetry on the axis, given tractions on the
/// contact line, no traction on free parts, the rest of a half-space beyond the far part, no displacement where the
/// body is bonded, and no vertical displacement and no shear where it slides on a flat base.
enum class BoundaryPart { axis = 1, contact = 2, free = 3, far = 4, bonded = 5, sliding = 6 };

/// Isotropic linear elasticity; every modulus relaxes with the same function of time.
struct Elasticity {
  double poisson_ratio = 0.5;       ///< 0 to 0.5, the same everywhere
  std::vector<double> moduli = {};  ///< shear modulus of each cell over that of the body; empty: 1
};

/// A quadrilateral grid of the (r, z) half-plane as plain data; the body fills z <= 0.
struct GridData {
  struct BoundaryEdge {
    std::array<unsigned, 2> points;
    BoundaryPart part;
  };
  std::vector<std::array<double, 2>> points;   ///< (r, z)
  std::vector<std::array<unsigned, 4>> cells;  ///< counter-clockwise corner indices
  std::vector<BoundaryEdge> boundary;
  Elasticity elasticity = {};
};

}  // namespace fretval::fem
