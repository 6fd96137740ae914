#pragma once

#include <filesystem>
#include <string>

#include "comparison/report/text/filling.h"

namespace fretval {

/// Section about every trade.json below a folder: recommended settings next to the tool's own choice, the front,
/// the other levels, what each axis gives alone, figures. Null if there is none. Throws InputError if one cannot be
/// read.
Filling trade_section(const std::filesystem::path& folder);

/// The tables of a trade.json for a terminal.
std::string trade_text(const nlohmann::ordered_json& trade);

}  // namespace fretval
