#pragma once

#include "comparison/case/entry_reader.h"

namespace fretval {

/// The sections of a case file that describe the case. Measured tables are read, and moduli fitted, here: what follows
/// sees numbers. Each throws InputError.
Case::Indenter read_indenter(const EntryReader& entries);
Case::Motion read_motion(const EntryReader& entries);

/// warnings: about measured moduli that fit badly or contradict themselves.
Case::Elastomer read_elastomer(const EntryReader& entries, std::vector<std::string>& warnings);

}  // namespace fretval
