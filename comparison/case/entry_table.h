#pragma once

#include <string>
#include <vector>

#include "comparison/case/problems.h"
#include "comparison/case/units.h"

namespace fretval {

/// An entry of a case file. This table is the only place that lists them: reading, messages and docs/case_file.md
/// (`fretval explain --entries`) follow it.
struct EntryTraits {
  const char* name;
  std::vector<Dimension> dimensions;  ///< of its number or, in turn, of the numbers of its list; empty: a word
  const char* values;                 ///< what it may be
  const char* without;                ///< what holds where it is not set
  const char* about;
};

struct SectionTraits {
  const char* name;
  std::vector<EntryTraits> entries;
};

const std::vector<SectionTraits>& case_sections();

/// Null: there is no such entry.
const EntryTraits* find_entry(const std::string& section, const std::string& name);
bool is_entry(const std::string& section, const std::string& name);
bool is_section(const std::string& section);

/// "Indenter: Shape, Radius, ...; Elastomer: ...", for error messages.
std::string valid_entries();

/// What is wrong with a section or an entry that there is not, and what may have been meant, which the problems note.
std::string no_such_section(const std::string& section, Problems& problems);
std::string no_such_entry(const std::string& section, const std::string& name, Problems& problems);

/// All entries with values, units and meaning, in Markdown.
std::string entries_reference();

}  // namespace fretval
