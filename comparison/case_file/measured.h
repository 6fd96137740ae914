#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparison/case_file/entry_reader.h"

namespace fretval {

/// The subsection Measured; empty if nothing is set there. notes: what was skipped in the table of loops.
std::optional<Case::Measured> read_measured(const EntryReader& entries, std::vector<std::string>& notes);

}  // namespace fretval
