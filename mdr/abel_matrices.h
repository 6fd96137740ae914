#pragma once

#include <Eigen/Core>

#include "mdr/spring_bed.h"

namespace fretval::mdr {

/// The transforms between the springs of a bed and the rings of surface over their intervals as square matrices, for
/// use again and again on the same bed. The kernels are integrated exactly, so no entry is singular. All are
/// triangular: heights and displacements act outwards, loads inwards, as the transforms do.
struct AbelMatrices {
  Eigen::MatrixXd image;         ///< heights at the middles of the rings, linear between -> image at the springs, (3)
  Eigen::MatrixXd stress;        ///< loads q in N/m, constant per interval -> mean stress on the rings in Pa of
                                 ///< -(1/pi) int_r q'(x)/sqrt(x^2-r^2) dx; 0 on a ring beyond the last loaded spring
  Eigen::MatrixXd displacement;  ///< displacements of the springs, constant per interval -> of the surface at the
                                 ///< middles of the rings, (2/pi) int_0^r u(x)/sqrt(r^2-x^2) dx
};

/// Throws std::invalid_argument unless all intervals have the same width.
AbelMatrices abel_matrices(const SpringBed& bed);

}  // namespace fretval::mdr
