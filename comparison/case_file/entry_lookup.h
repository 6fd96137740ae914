#pragma once

#include <string>
#include <vector>

#include "comparison/case_file/entry_table.h"
#include "comparison/case_file/problems.h"

namespace fretval {

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
