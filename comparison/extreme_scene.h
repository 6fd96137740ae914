#pragma once

#include <map>
#include <string>

#include "comparison/case.h"

namespace fretval {

/// Entries of a case file by "SECTION / ENTRY". An empty value: the entry is not set.
using Entries = std::map<std::string, std::string>;

/// A number as a case file takes it, exact to the last bit.
std::string entry_text(double value);

/// The scene that the suite `extremes` departs from: a parabola of 10 mm on a standard solid with |G|/G'(0) = 1.22,
/// d0 = 0.1 mm, Delta d = 0.2 d0, phase 60 degrees, k = 1, tolerance 1e-2.
Entries extremes_base();

/// The same entries but for the changed ones.
Entries with(Entries entries, const Entries& changes);

/// The same scene with the tangential amplitude that shakes down at a stick radius of c, stick_ratio = c over the
/// unworn contact radius at the largest indentation, times a factor; 0: at the border to where nothing sticks. Throws
/// InputError if there is none.
Entries with_stick_ratio(const Entries& entries, double stick_ratio, double factor = 1);

/// Reads the entries as `fretval run` reads a case file. Throws InputError.
Case case_of(const Entries& entries, const std::string& name);

/// The path of a measured profile of the suite, for Indenter / Table.
std::string extremes_table(const std::string& file);

}  // namespace fretval
