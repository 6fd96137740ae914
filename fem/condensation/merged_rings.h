#pragma once

#include <vector>

#include "fem/condensation/compliance.h"

namespace fretval::fem {

/// The compliance of a body on wider rings, each made of neighbouring rings that carry the same traction: with P, which
/// has a one where a ring is part of a wider one, the matrix is `P^T C P` and the areas are `P^T A`. radii: those of
/// the wider rings, a selection of the radii of the compliance from 0 to its last; all components get the same. The
/// rings of its half_space are merged as well, as far as it has them. Throws std::invalid_argument for other radii.
Compliance merged_rings(const Compliance& compliance, const std::vector<double>& radii);

}  // namespace fretval::fem
