#pragma once

#include <string>
#include <vector>

#include "comparison/case_file/entry_reader.h"

namespace fretval {

/// The sections of a case file that describe the case. Measured tables are read, and moduli fitted, here: what follows
/// sees numbers. notes: what was skipped in tables, and how they were processed.
Case::Indenter read_indenter(const EntryReader& entries, std::vector<std::string>& notes);
/// tangential: whether the indenter moves tangentially, against which a frictionless base holds nothing.
Case::Body read_body(const EntryReader& entries, bool tangential);

Case::Motion read_motion(const EntryReader& entries, std::vector<std::string>& notes);

/// motion: where it goes in two directions, friction has to be a vector.
Case::Contact read_contact(const EntryReader& entries, const Case::Motion& motion);

/// Path of a table of radii and heights, with units; empty where there is a problem, which is noted.
std::string read_table_path(const EntryReader& entries, const std::string& section, const std::string& name,
                            std::vector<std::string>& notes);

/// warnings: about measured moduli that fit badly or contradict themselves.
Case::Elastomer read_elastomer(const EntryReader& entries, std::vector<std::string>& warnings,
                               std::vector<std::string>& notes);

}  // namespace fretval
