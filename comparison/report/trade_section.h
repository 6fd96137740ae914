#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace fretval {

/// HTML section about every trade.json below a folder: recommended settings next to the tool's own choice, the front,
/// the other levels, what each axis gives alone, figures. Empty if there is none. Throws InputError if one cannot be
/// read, std::runtime_error if gnuplot fails.
std::string trade_section(const std::filesystem::path& folder);

/// The tables of a trade.json for a terminal.
std::string trade_text(const nlohmann::ordered_json& trade);

}  // namespace fretval
