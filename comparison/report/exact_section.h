#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace fretval {

/// HTML section of a verification ladder as convergence_json writes it: a table with the errors at each resolution, the
/// orders and the verdicts. Throws nlohmann::json::exception for JSON of another kind.
std::string convergence_section(const nlohmann::ordered_json& rows);

}  // namespace fretval
