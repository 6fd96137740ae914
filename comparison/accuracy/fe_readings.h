#pragma once

#include "comparison/quantities/reading.h"
#include "comparison/simulation/fe_answer.h"

namespace fretval {

/// What finite elements say of each quantity, those without a value as well that every case could have. The uncertainty
/// is that of reading edges, which a refinement does not show; nothing is compared where the whole contact slides.
Readings readings_of(const FeAnswer& fe, const Units& units);

/// Where rings touch in any order the unit of length is no contact radius: 0.
Scales scales_of(const FeAnswer& fe, const Units& units);

/// What is compared, in the units of that.
Quantities compared_quantities(const Readings& readings, const Scales& scales, const Units& units);

/// Of finite elements.
Quantities quantities_of(const FeAnswer& fe, const Units& units);

}  // namespace fretval
