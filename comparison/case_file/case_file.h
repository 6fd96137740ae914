#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "comparison/case/case.h"

namespace fretval {

/// Reads a case file (.prm of deal.II's ParameterHandler, or .json with sections as objects of entries) and the files
/// it includes (`include FILE` lines before the first subsection, relative to the file; its own entries override
/// included ones). Within one file an entry may be set once. Numbers may have a unit of what the entry measures ("5
/// mm", see docs/case_file.md); without one they are SI, angles in degrees, frequencies in Hz.
///
/// A file with a subsection Sweep stands for several cases, one per value of the swept entry; without one, for a single
/// case. The name of a file becomes that of a folder of results; what cannot be one is refused. Throws InputError
/// with a line for everything that is wrong in the file, which names the entry, its value and what would be valid.
std::vector<Case> read_case_file(const std::filesystem::path& file, Accuracy accuracy = Accuracy::needed);

/// Cases for MDR's line beside the points of a sweep, at values that divide the intervals between neighbouring points
/// equally, about n in all. Empty: no sweep, one of a single value, or over an entry that does not take values between,
/// a whole number. Throws as read_case_file() does.
std::vector<Case> cases_between(const std::filesystem::path& file, std::size_t n);

/// A single case from the text of a .prm file without includes or a sweep. name: what the file would be called; tables
/// are relative to it. Throws InputError with a line for everything that is wrong.
Case read_case_text(const std::string& text, const std::filesystem::path& name);

}  // namespace fretval
