#pragma once

#include <filesystem>
#include <string>

namespace fretval {

/// Computes the speed-accuracy trade of the single case in a file, writes output/NAME/trade.json and prints the front,
/// the rates and the recommended settings; returns the exit code. Throws InputError, also for a sweep.
int run_trade(const std::string& file, const std::filesystem::path& output);

}  // namespace fretval
