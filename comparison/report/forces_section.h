#pragma once

#include <string>
#include <vector>

#include "comparison/results/results_folder.h"

namespace fretval {

/// HTML section about the cases in which a force is prescribed: stick radii, what the indenter does under the forces,
/// and when the contact slides as a whole. Empty if there is none.
std::string forces_section(const std::vector<StoredResult>& results);

}  // namespace fretval
