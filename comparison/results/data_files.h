#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

#include "comparison/case/case.h"

namespace fretval {

/// Writes the data from which the input of a case was made: trace.csv and aligned_profile.csv of a trace that was
/// aligned, and measured_loops.csv of what a rig has measured.
void write_data(const Case& input, const std::filesystem::path& folder);

/// How the data of a case were processed, for scene.data of result.json: trace, record, test_duration, hardness; and
/// measured radii, with their uncertainties. SI units. An empty object: they were taken as they are.
nlohmann::ordered_json data_json(const Case& input);

}  // namespace fretval
