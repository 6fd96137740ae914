#pragma once

#include <cstddef>
#include <string>

#include "comparison/case/case.h"

namespace fretval {

/// What a case is, for people, before finite elements compute it: its inputs, the dimensionless groups that it depends
/// on, MDR's answer and so which stick radii exist, what finite elements would compute and about how long that takes;
/// or why they do not. n_cases: of the sweep that it is the first of. Throws InputError.
std::string explanation(const Case& input, std::size_t n_cases = 1);

}  // namespace fretval
