#pragma once

#include <vector>

#include "fem/condensation/compliance.h"

namespace fretval::fem {

/// The same body with wider rings, each of some neighbours that carry the same traction: with P, which has a one where
/// a ring is part of a wider one, the matrix is `P^T C P` and the areas are `P^T A`. radii: of the wider rings, some of
/// those of the compliance, from 0 to its end; of several components each has them. The half-space that knows its edges has wider rings as far as it has
/// them. Throws std::invalid_argument for other radii.
Compliance merged_rings(const Compliance& compliance, const std::vector<double>& radii);

}  // namespace fretval::fem
