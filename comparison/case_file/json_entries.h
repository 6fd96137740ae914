#pragma once

#include <filesystem>
#include <string>

#include "comparison/case_file/entry_texts.h"
#include "comparison/case_file/problems.h"

namespace fretval {

/// Reads sections of entries from JSON: {"Indenter": {"Shape": "cone", "Slope angle": 5}}; a list may be an array.
/// Unknown sections and entries and values of the wrong kind become problems. Throws InputError for text that is not
/// such JSON and for a key that comes twice.
void parse_json_entries(const std::string& text, const std::filesystem::path& file, EntryTexts& entries,
                        Problems& problems);

}  // namespace fretval
