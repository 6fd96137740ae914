#pragma once

#include <optional>

#include "comparison/accuracy/prepared_case.h"
#include "comparison/accuracy/proof.h"

namespace fretval {

/// Rings of a given mesh, which are not refined.
struct GivenRings {
  unsigned in_contact;             ///< in the largest contact
  std::optional<unsigned> needed;  ///< for the tolerance; empty: these are enough
};

/// Of a bar that is wider than its tolerance T, rings and the reading of edges have a share that falls with the power
/// of the rings that was observed (2 where none was), and the cells one that falls with the first: it takes as many
/// rings as bring both within T less the rest of the bar or, where the rest leaves less, within T/2. The most of all
/// quantities that were asked for. Without a proof nothing is known to lack. Empty: the mesh is not given, or the whole
/// contact slides.
std::optional<GivenRings> given_rings_of(const PreparedCase& prepared, const ProvedAnswer& answer);

}  // namespace fretval
