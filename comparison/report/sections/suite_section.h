#pragma once

#include <string>

#include "comparison/report/text/filling.h"

namespace fretval {

/// Section of a suite as suite_json writes it: verdict and counts, a line for each quantity and tolerance, all error
/// bars over their errors as a figure where all rows are there, and the rows with their case files. Throws
/// nlohmann::json::exception for JSON of another kind.
Filling suite_section(const nlohmann::ordered_json& json);

/// The text of the section for a terminal, without the figure and the case files.
std::string suite_text(const nlohmann::ordered_json& json);

}  // namespace fretval
