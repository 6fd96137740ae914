#pragma once

#include <stdexcept>

namespace fretval::fem {

/// The numerics failed: a factorisation, an iteration or a history that does not become periodic. The message names the
/// step, the measured value and what to change.
struct SolverError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace fretval::fem
