#pragma once

#include <vector>

#include "comparison/report/text/render.h"
#include "comparison/results/results_folder.h"

namespace fretval {

/// For the template `scene`: the sketch of a case, all that its file prescribes, with units, and the dimensionless
/// groups.
Filling scene_of(const StoredResult& result);

/// The scene of the first case of each sweep. Null without a sweep.
Filling scenes_section(const std::vector<StoredResult>& results);

/// Of the inputs in a result.json, by the name of the entry; NaN if it is not there or no number.
double input_number(const nlohmann::ordered_json& scene, const char* name);

}  // namespace fretval
