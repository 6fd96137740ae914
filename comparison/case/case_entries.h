#pragma once

#include <string>

#include "comparison/case/case.h"
#include "comparison/case/entry_reader.h"

namespace fretval {

/// Declares every entry of a case file, all without a default: what is not set is an error where it is needed.
void declare_entries(dealii::ParameterHandler& handler);

bool is_entry(const std::string& section, const std::string& name);

/// "Indenter: Shape, Radius, ...; Elastomer: ...", for error messages.
std::string valid_entries();

/// Everything but the name. fields: what to write when the file does not say.
Case read_entries(const EntryReader& entries, Case::Fields fields);

}  // namespace fretval
