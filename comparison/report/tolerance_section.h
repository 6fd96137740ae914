#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace fretval {

/// HTML of what the suite `tolerance` found (see tolerance_json): a table with a line a tolerance, a plot of error bars
/// over true errors and one of cost ratios. Empty for a JSON without records. Throws nlohmann::json::exception for JSON
/// of another kind, std::runtime_error without gnuplot.
std::string tolerance_section(const nlohmann::ordered_json& json);

}  // namespace fretval
