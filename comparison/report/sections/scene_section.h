#pragma once

#include <vector>

#include "comparison/report/text/filling.h"
#include "comparison/results/results_folder.h"

namespace fretval {

/// What a case file prescribes (`inputs` of a JSON, see inputs_json) by its sections, for the template `scene`.
Filling inputs_of(const nlohmann::ordered_json& scene);

/// For the template `scene`: the sketch of a case, all that its file prescribes, with units, and the dimensionless
/// groups.
Filling scene_of(const StoredResult& result);

/// The scene of the first case of each sweep. Null without a sweep.
Filling scenes_section(const std::vector<StoredResult>& results);

}  // namespace fretval
