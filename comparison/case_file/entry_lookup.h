#pragma once

#include <set>
#include <string>
#include <vector>

#include "comparison/case_file/entry_table.h"

namespace fretval {

/// Everything that is wrong with a case file, so that it can be said at once.
struct Problems {
  std::vector<std::string> messages;
  /// "SECTION" or "SECTION / ENTRY" that was probably meant by an unknown name: it is not reported as missing in
  /// addition.
  std::set<std::string> meant;
  /// Whether lines could not be understood: entries that seem to be missing may stand there.
  bool has_unread_lines = false;

  /// Adds a message, unless it is there already.
  void add(const std::string& message);
  /// Throws InputError with a line for each.
  void throw_if_any() const;
};

/// The section or entry of a name; null: there is none.
const SectionTraits* find_section(const std::string& name);
const EntryTraits* find_entry(const std::string& section, const std::string& name);
/// The entry that a sweep names as "SECTION / ENTRY"; null: there is none.
const EntryTraits* find_entry(const std::string& place);
/// "SECTION / ENTRY" taken apart. Without the stroke all of it is the section.
struct EntryPlace {
  std::string section, entry;
};
EntryPlace place_of(const std::string& text);
bool is_entry(const std::string& section, const std::string& name);
/// The names of all entries of a section but those in `others`.
std::vector<std::string> names_but(const std::string& section, const std::vector<std::string>& others);

/// "Indenter: Shape, Radius, ...; Elastomer: ...", for error messages.
std::string valid_entries();

/// Message about a section or an entry that does not exist, with what may have been meant, which the problems note.
std::string no_such_section(const std::string& section, Problems& problems);
std::string no_such_entry(const std::string& section, const std::string& name, Problems& problems);

/// All entries with values, units and meaning, in Markdown.
std::string entries_reference();

}  // namespace fretval
