#pragma once

#include <vector>

#include "comparison/report/text/filling.h"
#include "comparison/results/results_folder.h"

namespace fretval {

/// Section about the cases in which a force is prescribed: stick radii, what the indenter does under the forces,
/// and when the contact slides as a whole. Null if there is none.
Filling forces_section(const std::vector<StoredResult>& results);

}  // namespace fretval
