#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "comparison/case_file/entry_texts.h"
#include "comparison/case_file/problems.h"

namespace fretval {

/// The contents of a single .prm file.
struct PrmFile {
  std::vector<std::filesystem::path> included;  ///< files whose entries its own override
  EntryTexts entries;
};

/// Reads the format of deal.II's ParameterHandler: `subsection NAME`, `set ENTRY = VALUE`, `end`, `include FILE` before
/// the first subsection; # begins a comment, a backslash at the end of a line joins the next one. Sections do not nest.
/// Other lines, an entry that is set twice, and unknown sections and entries become problems. Throws InputError for an
/// include that stands wrong or names no file.
PrmFile read_prm(const std::string& text, const std::filesystem::path& file, Problems& problems);

}  // namespace fretval
