#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "comparison/case_file/entry_lookup.h"

namespace fretval {

/// Texts of entries as case files set them, by section and name.
class EntryTexts {
 public:
  void set(const std::string& section, const std::string& name, std::string text) {
    texts_[{section, name}] = std::move(text);
  }
  /// Sets all entries of another file, which replace those that are set already.
  void override_by(const EntryTexts& other) {
    for (const auto& [key, text] : other.texts_) texts_[key] = text;
  }
  /// The text of an entry; empty if it is not set.
  [[nodiscard]] std::string text(const std::string& section, const std::string& name) const {
    const auto found = texts_.find({section, name});
    return found == texts_.end() ? "" : found->second;
  }

 private:
  std::map<std::pair<std::string, std::string>, std::string> texts_;
};

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

/// Reads sections of entries from JSON: {"Indenter": {"Shape": "cone", "Slope angle": 5}}; a list may be an array.
/// Unknown sections and entries and values of the wrong kind become problems. Throws InputError for text that is not
/// such JSON and for a key that comes twice.
void parse_json_entries(const std::string& text, const std::filesystem::path& file, EntryTexts& entries,
                        Problems& problems);

}  // namespace fretval
