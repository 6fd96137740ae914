#pragma once

#include <cstdint>
#include <optional>

#include "comparison/verification/random_cases/random_cases.h"
#include "comparison/verification/suite.h"

namespace fretval {

struct RandomSuiteOptions {
  std::uint64_t seed;
  std::size_t n_cases = 10000;
  std::optional<std::size_t> only = {};  ///< the number of the one case that is to be run, from 0
};

/// Random cases on one coarse discretisation whose bodies are made once, each with its error bars (Proof::bars) but
/// without any refinement. Bars may be wider than the tolerance, and are infinite where a coarser computation lacks the
/// quantity; errors have to be within them. A case that the tool refuses as bad input (InputError) is drawn again, at
/// most 100 times; nothing else is left out.
SuiteRun run_random_suite(const RandomSuiteOptions& options);

}  // namespace fretval
