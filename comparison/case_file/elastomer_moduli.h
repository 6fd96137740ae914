#pragma once

#include <string>
#include <vector>

#include "comparison/case_file/entry_reader.h"

namespace fretval {

/// The relaxed modulus of an elastomer that is no table: read from an entry, or from a hardness. Problems are noted.
/// notes: what was derived from what.
void read_relaxed_modulus(const EntryReader& entries, Case::Elastomer& elastomer, std::vector<std::string>& notes);

/// Reads the branches of an elastomer, moduli or ratios, and times, from entries or from a file (branches_file.h). To
/// be called after read_relaxed_modulus(); with ratios and an instantaneous modulus the relaxed one follows here.
void read_branches(const EntryReader& entries, Case::Elastomer& elastomer, std::vector<std::string>& notes);

}  // namespace fretval
