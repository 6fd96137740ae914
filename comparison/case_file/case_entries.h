#pragma once

#include "comparison/case/case.h"
#include "comparison/case_file/entry_reader.h"

namespace fretval {

/// Everything but the name. Throws InputError with everything that is wrong.
Case read_entries(const EntryReader& entries, Accuracy accuracy);

}  // namespace fretval
