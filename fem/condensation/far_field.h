#pragma once

#include <Eigen/Dense>

#include "fem/condensation/compliance.h"
#include "fem/condensation/condensation.h"
#include "fem/operators/harmonic_space.h"

namespace fretval::fem {

/// Forces on the skeleton dofs of a half-space that are missing in the condition at its far boundary
/// (assemble_stiffness) where a unit force acts at the origin, along z (n = 0) or along x (n = 1):
///
///   int [sigma m + (3/R)(u.n) n] . v dA
///
/// with u and sigma of Boussinesq's and Cerruti's point forces (Johnson, Contact Mechanics, 3.2 and 3.6), m the normal
/// of the straight mesh edges and n that of the hemisphere. It vanishes for nu = 1/2.
Eigen::VectorXd far_residual(const HarmonicSpace& space);

/// Whether the condition at the far boundary of a space lacks anything: a compressible body that has one, of an order
/// in which rings exert a force.
bool lacks_far_field(const HarmonicSpace& space);

/// Adds to a compliance what the far boundary lacks, so that it is exact for the total force of the rings, as it is for
/// nu = 1/2 by itself; what is left is the error of the moments of their tractions, of the third power of radius over
/// distance. condensation: that of the stiffness of the space; components: those of the displacement that the
/// compliance has, see HarmonicSpace::contact_line.
void add_far_field(const HarmonicSpace& space, const Condensation& condensation,
                   const std::vector<unsigned>& components, Compliance& compliance);

}  // namespace fretval::fem
