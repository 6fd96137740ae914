#pragma once

#include "comparison/report/text/filling.h"
#include "comparison/results/results_folder.h"

namespace fretval {

/// For the template `assumptions`: what a case takes for granted, each with a number of the case that says how far it
/// holds: slope at the edge of the contact, a parabola's distance from the arc, how close to lifting off, how deep a
/// layer has to be to count as a half-space, and what the far boundary of the finite elements does.
Filling assumptions_of(const StoredResult& result);

}  // namespace fretval
