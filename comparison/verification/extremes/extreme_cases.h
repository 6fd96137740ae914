#pragma once

#include <string>
#include <vector>

#include "comparison/verification/case_parts.h"
#include "comparison/verification/suite.h"

namespace fretval {

/// The base of all cases: a parabola of 10 mm on a standard solid with |G|/G'(0) = 1.22, d0 = 0.1 mm, Delta d = 0.2 d0,
/// phase 60 degrees, k = 1, tolerance 1e-2.
Entries extremes_base();

/// The base of extremes_base() with an elastic body.
Entries elastic_base();

/// The cases of the suite `extremes`: families that go to the ends of one parameter each. Throws InputError if a case
/// cannot be set up.
std::vector<SuiteCase> extreme_cases();

/// The first case of each family.
std::vector<SuiteCase> short_extreme_cases();

/// The cases whose family contains a text.
std::vector<SuiteCase> only_family(const std::vector<SuiteCase>& cases, const std::string& text);

SuiteRun run_extreme_suite(const std::vector<SuiteCase>& cases);

}  // namespace fretval
