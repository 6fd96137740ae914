#pragma once

#include <string>
#include <vector>

#include "comparison/case/case.h"

namespace fretval {

/// What a case is, for people, before finite elements compute it: its inputs, the dimensionless groups that it depends
/// on, MDR's answer and so which stick radii exist, what finite elements would compute and about how long that takes;
/// or why they do not. No time is told where finite elements look for a stick zone that is small, or that MDR does not
/// have. sweep: the cases of the sweep of which it is the first. Throws InputError.
std::string explanation(const Case& input, const std::vector<Case>& sweep = {});

}  // namespace fretval
