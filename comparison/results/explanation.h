#pragma once

#include <string>

#include "comparison/case/case.h"

namespace fretval {

/// What a case is, for people, before finite elements compute it: its inputs, the dimensionless groups that it depends
/// on, MDR's answer and so which stick radii exist, what finite elements would compute and about how long that takes;
/// or why they do not. Throws InputError.
std::string explanation(const Case& input);

/// About how long finite elements need for a case with its proof, in s on one core like that of docs/verification.md;
/// right to a factor of three. Wear is not counted.
double estimated_seconds(double tolerance, bool memory, int highest_order, std::size_t n_computations);

}  // namespace fretval
