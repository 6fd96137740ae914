#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace fretval {

/// HTML section of the suite `soak` as soak_json writes it: the verdict, the distribution of each quantity, the memory
/// and the ten worst cases with their case files. Throws nlohmann::json::exception for JSON of another kind.
std::string soak_section(const nlohmann::ordered_json& json);

}  // namespace fretval
