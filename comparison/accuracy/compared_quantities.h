#pragma once

#include <map>
#include <string>

namespace fretval {

struct FeAnswer;
struct MdrAnswer;
struct Units;

/// Quantities of a scene by the names of result.json, in the units of comparison: radii over the unworn contact radius
/// (0: nothing sticks), logarithms of forces, so that differences are relative.
using Measures = std::map<std::string, double>;

/// What finite elements say.
Measures measures_of(const FeAnswer& fe, const Units& units);

/// What MDR says. worn: also of the state of a limiting profile in which nothing wears: no slip inside, no force
/// outside, the flank touches at the largest indentation.
Measures measures_of(const MdrAnswer& mdr, const Units& units, bool worn);

/// Absolute differences of what both have: over the contact radius for radii, relative for forces.
Measures errors_of(const Measures& measures, const Measures& reference);

/// The largest one; NaN for none.
double largest_of(const Measures& errors);

}  // namespace fretval
