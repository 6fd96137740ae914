#pragma once

#include <functional>

#include "comparison/case/case.h"
#include "comparison/scene/from_mdr.h"
#include "comparison/simulation/fem_case/units.h"
#include "mdr/profiles/profile.h"

namespace fretval {

/// Height of an indenter over the radius, dimensionless. unworn: of a table.
std::function<double(double)> profile_in(const Units& units, const Case::Indenter& indenter,
                                         const mdr::Profile& unworn);
std::function<double(double)> profile_in(const Units& units, const LimitingIndenter& limiting);

/// Radius in m beyond which an indenter is higher than it is pressed in by, `depth` in m. Surfaces that are pressed
/// sink everywhere, so it touches no further out. Throws InputError where a table ends before.
double farthest_depth(const Case& input, const mdr::Profile& profile, double depth);

}  // namespace fretval
