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

/// The rings of a given mesh in the largest contact, and how many the tolerance needs. In a bar that is wider than its
/// tolerance T, the shares of rings and of the reading of edges are taken to fall with the observed power of the number
/// of rings (2 where none was observed), and that of the cells with the first power. So many rings are needed that
/// these shares are within T less the rest of the bar or, where the rest leaves less, within T/2; the largest number of
/// all quantities that are asked for counts. Without a proof no need is known. Empty: the mesh is not given, or the
/// whole contact slides, or the numerics failed.
std::optional<GivenRings> given_rings_of(const PreparedCase& prepared, const ProvedAnswer& answer);

}  // namespace fretval
