#pragma once

#include <vector>

#include "comparison/case_file/units.h"

namespace fretval {

/// An entry of a case file. This table is the only place that lists them: reading, messages and docs/case_file.md
/// (`fretval explain --entries`) follow it (comparison/case_file/entry_lookup.h).
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

}  // namespace fretval
