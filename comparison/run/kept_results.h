#pragma once

#include <filesystem>
#include <optional>

#include "comparison/run/batch.h"

namespace fretval {

/// What an earlier run has written about a case, if that is what this run would write: the result is whole, of the same
/// version of the program, the same inputs and as far proved, and no file that the case reads is newer. Empty: compute
/// it. output: folder of the results.
std::optional<BatchLine> kept_line(const PreparedCase& prepared, Proof proof, const std::filesystem::path& output);

}  // namespace fretval
