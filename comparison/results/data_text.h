#pragma once

#include <string>

#include "comparison/case/case.h"

namespace fretval {

/// Rows of `fretval explain` on the data of a case: what a test of limited duration sees, with the branches near its
/// duration and MDR's answer to a test three times longer and shorter; and the uncertainties of MDR's answer from the
/// record, the trace and the hardness. Each row begins with a word; empty: the data were taken as they are.
std::string data_text(const Case& input);

/// What a test of limited duration does not see, in one sentence for the log; empty: nothing, or MDR has no answer.
std::string duration_text(const Case& input);

}  // namespace fretval
