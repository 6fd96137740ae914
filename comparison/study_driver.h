#pragma once

#include <functional>
#include <vector>

#include "comparison/body.h"
#include "comparison/case_study.h"

namespace fretval {

/// Runs studies until all are finished: what they want is computed round by round, together, so that they share bodies
/// and normal histories (see run_probes). The studies' cases must outlive the call.
void run_studies(std::vector<CaseStudy>& studies, const std::function<Body(const BodySpecification&)>& make_body,
                 Schedule schedule = Schedule::overlapped);

}  // namespace fretval
