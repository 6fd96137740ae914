#pragma once

#include <Eigen/Dense>

#include "fem/condensation/compliance.h"

namespace fretval::fem {

/// Sums of neighbouring rows, two each; an odd one at the end is left out.
Eigen::MatrixXd sums_of_pairs(const Eigen::MatrixXd& rows);

/// Of rings of twice the width under uniform pressure, on the same mesh: rings 2i and 2i + 1 are one. The same of the
/// half-space that the compliance knows.
Compliance with_wider_rings(const Compliance& compliance);

}  // namespace fretval::fem
