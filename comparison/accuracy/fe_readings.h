#pragma once

#include "comparison/quantities/reading.h"
#include "comparison/simulation/fe_answer.h"

namespace fretval {

/// Values of the quantities by finite elements, in SI units; of those that every case could have also the ones without
/// a value. The uncertainty is that of reading edges, which a refinement does not show. Nothing is compared where the
/// whole contact slides.
Readings readings_of(const FeAnswer& fe, const Units& units);

/// Scales of the differences of a case. Where rings touch in any order the unit of length is no contact radius, and the
/// scale of radii is 0.
Scales scales_of(const FeAnswer& fe, const Units& units);

/// The readings that are compared, in the units of comparison (Quantities). A quantity whose differences are relative
/// is left out where it is not positive, as the loop of a small amplitude on coarse rings: nothing is known of it.
Quantities compared_quantities(const Readings& readings, const Scales& scales, const Units& units);

/// The quantities of an answer of the finite elements, in the units of comparison.
Quantities quantities_of(const FeAnswer& fe, const Units& units);

}  // namespace fretval
