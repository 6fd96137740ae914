#pragma once

#include <filesystem>
#include <string>

#include "comparison/case_file/entry_texts.h"
#include "comparison/case_file/problems.h"

namespace fretval {

/// Sections of entries: {"Indenter": {"Shape": "cone", "Slope angle": 5}}; a list may be an array. Sections and entries
/// that there are not, and values of the wrong kind, become problems; throws InputError for what is no such JSON and
/// for a key that comes twice.
void parse_json_entries(const std::string& text, const std::filesystem::path& file, EntryTexts& entries,
                        Problems& problems);

}  // namespace fretval
