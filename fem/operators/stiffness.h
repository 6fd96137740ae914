#pragma once

#include "fem/operators/harmonic_space.h"
#include "fem/operators/sparse_matrix.h"

namespace fretval::fem {

/// Stiffness of the incompressible body with unit shear modulus, mixed in displacement and pressure:
/// `2 pi w_n int [2 eps(u):eps(v) - P div v - Q div u] r dr dz`, w_0 = 1, w_1 = 1/2 (angular means of 1 and cos^2),
/// with the strains of the harmonic (strain_operator.h).
///
/// Far field: the point-load solutions of Boussinesq and Cerruti in an incompressible half-space satisfy
/// `t = -(3 G / R)(u.n) n` on a hemisphere of radius R; added as a Robin term (with the
/// tilt of the straight mesh edges), it scales with the shear modulus like the rest.
/// Symmetric, indefinite. Rows of constrained dofs hold their diagonal alone. Force per length for lengths in any unit.
SparseMatrix assemble_stiffness(const HarmonicSpace& space);

}  // namespace fretval::fem
