#pragma once

#include "comparison/case/case.h"
#include "comparison/case/entry_reader.h"

namespace fretval {

struct Reading {
  Case::Fields fields;  ///< what to write when the file does not say
  Accuracy accuracy;
};

/// Everything but the name. Throws InputError with everything that is wrong.
Case read_entries(const EntryReader& entries, const Reading& reading);

}  // namespace fretval
