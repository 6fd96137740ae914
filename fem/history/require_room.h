#pragma once

#include <Eigen/Dense>

namespace fretval::fem {

/// Throws SolverError if the last ring of the contact line carries pressure: then the contact may be wider than the
/// line.
void require_room(const Eigen::VectorXd& pressure);

}  // namespace fretval::fem
