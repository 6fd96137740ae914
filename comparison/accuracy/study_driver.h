#pragma once

#include <functional>
#include <vector>

#include "comparison/accuracy/case_study.h"

namespace fretval {

/// Runs studies until all are finished: what they want is computed round by round, together, so that they share normal
/// histories (see run_probes); every body is made once. The studies' cases must outlive the call. finished is called
/// with the number of each study when it has all that it wants, one call at a time, while others may go on: it must not
/// make bodies.
void run_studies(
    std::vector<CaseStudy>& studies, const MakeBody& make_body,
    const std::function<void(std::size_t study)>& finished = [](auto) {});

/// The same with bodies that outlive the call.
void run_studies(
    std::vector<CaseStudy>& studies, BodyStore& bodies,
    const std::function<void(std::size_t study)>& finished = [](auto) {});

}  // namespace fretval
