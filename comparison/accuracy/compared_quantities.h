#pragma once

#include "comparison/accuracy/quantity.h"

namespace fretval {

struct FeAnswer;
struct MdrAnswer;
struct Units;

/// What finite elements say.
Quantities quantities_of(const FeAnswer& fe, const Units& units);

/// What MDR says. worn: also of the state of a limiting profile in which nothing wears: no slip inside, no force
/// outside, the flank touches at the largest indentation, slip begins inside beyond the amplitude it is limiting for.
Quantities quantities_of(const MdrAnswer& mdr, const Units& units, bool worn);

/// What springs that were stepped in time may be off by, in the units of the quantities; closed forms are not in it.
Quantities stepping_errors_of(const MdrAnswer& mdr);

/// Absolute differences of what both have, but for what comes along: over the contact radius for radii, relative for
/// forces.
Quantities errors_of(const Quantities& values, const Quantities& reference);

/// The largest one; NaN for none.
double largest_of(const Quantities& errors);

}  // namespace fretval
