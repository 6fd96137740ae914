#pragma once

#include <string>

#include "comparison/report/text/filling.h"

namespace fretval {

/// Section of the suite `exact` as convergence_json writes it: a table with the errors at each resolution, the
/// orders and the verdicts. Throws nlohmann::json::exception for JSON of another kind.
Filling convergence_section(const nlohmann::ordered_json& rows);

/// The text of the section for a terminal.
std::string convergence_text(const nlohmann::ordered_json& rows);

}  // namespace fretval
