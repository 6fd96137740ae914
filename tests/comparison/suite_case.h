#pragma once

#include <stdexcept>
#include <string>

#include "comparison/verification/suites.h"

namespace fretval {

/// A case of the tolerance suite by its name.
inline Case suite_case(const std::string& name, double tolerance) {
  for (const auto& one : tolerance_cases(tolerance))
    if (one.name == name) return case_of(one);
  throw std::invalid_argument(name);
}

}  // namespace fretval
