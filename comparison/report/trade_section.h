#pragma once

#include <filesystem>
#include <string>

namespace fretval {

/// HTML section about every trade.json below a folder: figures, recommended settings next to the tool's own choice, and
/// observed rates. Empty if there is none. Throws InputError if one cannot be read, std::runtime_error if gnuplot
/// fails.
std::string trade_section(const std::filesystem::path& folder);

}  // namespace fretval
