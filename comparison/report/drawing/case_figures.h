#pragma once

#include "comparison/report/text/filling.h"
#include "comparison/results/results_folder.h"

namespace fretval {

/// The cycle.json of a case; an empty object if it is not there. Throws InputError if it is no JSON.
nlohmann::ordered_json read_cycle(const StoredResult& result);

/// For the template `figures`: what happens under the indenter in the last period, loops of both forces, slip,
/// profiles, and what makes up the error bars; as far as the files of the case are there.
Filling case_figures(const StoredResult& result, const nlohmann::ordered_json& cycle);

}  // namespace fretval
