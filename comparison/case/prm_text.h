#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "comparison/case/problems.h"

namespace fretval {

/// What a .prm file says by itself: which files it includes, and its lines without those, so that numbers stay right.
struct PrmText {
  std::vector<std::filesystem::path> included;
  std::string text;
};

/// Sections and entries that there are not become problems, and their lines blank. Throws InputError for an include
/// that stands wrong or names no file, and for an entry that is set twice.
PrmText read_prm(const std::string& text, const std::filesystem::path& file, Problems& problems);

}  // namespace fretval
