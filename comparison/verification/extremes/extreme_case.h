#pragma once

#include <string>

#include "comparison/verification/written_case.h"

namespace fretval {

/// The scene that the suite `extremes` departs from: a parabola of 10 mm on a standard solid with |G|/G'(0) = 1.22,
/// d0 = 0.1 mm, Delta d = 0.2 d0, phase 60 degrees, k = 1, tolerance 1e-2.
Entries extremes_base();

/// The path of a measured profile of the suite, for Indenter / Table.
std::string extremes_table(const std::string& file);

}  // namespace fretval
