#pragma once

#include <string>
#include <vector>

#include "comparison/case_file/entry_reader.h"

namespace fretval {

/// The relaxed modulus of an elastomer that is no table: an entry, or from a hardness. Problems are noted. notes: what
/// was made of what.
void read_relaxed_modulus(const EntryReader& entries, Case::Elastomer& elastomer, std::vector<std::string>& notes);

/// Its branches: moduli or ratios, and times, in entries or in a file (branches_file.h); after the relaxed modulus,
/// which follows from ratios and the instantaneous one.
void read_branches(const EntryReader& entries, Case::Elastomer& elastomer, std::vector<std::string>& notes);

}  // namespace fretval
