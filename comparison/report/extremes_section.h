#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace fretval {

/// HTML section of the suite `extremes` as extremes_json writes it: the counts of the verdicts and a table with a line
/// a scene. Throws nlohmann::json::exception for JSON of another kind.
std::string extremes_section(const nlohmann::ordered_json& json);

}  // namespace fretval
