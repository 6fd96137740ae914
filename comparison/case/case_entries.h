#pragma once

#include "comparison/case/case.h"
#include "comparison/case/entry_reader.h"

namespace fretval {

/// Declares every entry of a case file (see entry_table.h), all without a default: what is not set is an error where it
/// is needed.
void declare_entries(dealii::ParameterHandler& handler);

struct Reading {
  Case::Fields fields;  ///< what to write when the file does not say
  Accuracy accuracy;
};

/// Everything but the name. Throws InputError with everything that is wrong.
Case read_entries(const EntryReader& entries, const Reading& reading);

}  // namespace fretval
