#pragma once

#include <vector>

#include "comparison/case_study.h"

namespace fretval {

/// Runs studies until all are finished: what they want is computed round by round, together, so that they share normal
/// histories (see run_probes); every body is made once. The studies' cases must outlive the call.
void run_studies(std::vector<CaseStudy>& studies, const MakeBody& make_body);

}  // namespace fretval
