#pragma once

#include <Eigen/Dense>

#include "fem/condensation/compliance.h"

namespace fretval::fem {

/// Sums of pairs of neighbouring rows; an odd row at the end is left out.
Eigen::MatrixXd sums_of_pairs(const Eigen::MatrixXd& rows);

/// The compliance on rings of twice the width under uniform pressure, on the same mesh: rings 2i and 2i + 1 become one.
/// Its half_space gets wider rings, too.
Compliance with_wider_rings(const Compliance& compliance);

}  // namespace fretval::fem
