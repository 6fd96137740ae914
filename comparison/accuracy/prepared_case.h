#pragma once

#include <functional>
#include <vector>

#include "comparison/accuracy/verdict.h"
#include "comparison/reference/mdr_case.h"
#include "comparison/simulation/fem_case/fem_case.h"

namespace fretval {

/// A case ready to be computed both ways.
struct PreparedCase {
  Case input;
  MdrCase mdr;
  FemCase fem;
  Tolerances tolerances;
  /// Errors of MDR's springs, over the scales of the quantities: they take their part of the tolerances, and the bars
  /// of the finite elements have the rest. It may wait until they are known.
  std::function<Quantities()> reference_errors = [] { return Quantities{}; };

  /// Whether both methods are compared; false where MDR does not hold for the profile.
  [[nodiscard]] bool is_compared() const { return fem.kind != ContactKind::annuli; }
};

/// Checks everything about the cases that can be checked before the first one is computed. Throws InputError; bad
/// values that only the reference refuses are reported with the file's name.
std::vector<PreparedCase> prepare(const std::vector<Case>& cases);

}  // namespace fretval
