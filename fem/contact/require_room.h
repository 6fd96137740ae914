#pragma once

#include <Eigen/Dense>

#include "fem/support/solver_error.h"

namespace fretval::fem {

struct NoRoom : SolverError {
  using SolverError::SolverError;
};

/// Throws NoRoom if the last ring of the contact line carries pressure: then the contact may be wider than the
/// line.
void require_room(const Eigen::VectorXd& pressure);

}  // namespace fretval::fem
