#pragma once

#include <Eigen/Dense>
#include <ostream>

#include "fem/condensation/compliance.h"
#include "fem/condensation/condensation.h"
#include "fem/operators/harmonic_space.h"

namespace fretval::fem {

/// Displacements of the whole body that belong to given ring displacements: all dofs of the space, in the unit of the
/// rings. With every modulus proportional to G(t), the interior follows the surface instantly: no history is needed.
Eigen::VectorXd extend_into_body(const HarmonicSpace& space, const Condensation& condensation,
                                 const Compliance& compliance, const Eigen::VectorXd& ring_displacements);

/// Writes the mesh and the displacement amplitudes (n = 0: u_r, u_z; n = 1: u_r and u_z at theta = 0, u_theta at
/// theta = 90 degrees) of the half-plane in the VTU format. Coordinates are multiplied by length, displacements by
/// depth. For n = 0 a positive ring displacement points into the body.
void write_vtu(const HarmonicSpace& space, const Eigen::VectorXd& displacements, double length, double depth,
               std::ostream& stream);

}  // namespace fretval::fem
