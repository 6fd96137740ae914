#pragma once

#include <Eigen/Dense>

#include "fem/operators/harmonic_space.h"
#include "fem/operators/sparse_matrix.h"

namespace fretval::fem {

/// One of so many parts of about as many cells, as they follow each other.
struct Share {
  unsigned number = 0, count = 1;
};

/// Stiffness of the incompressible body with unit shear modulus, mixed in displacement and pressure:
/// `2 pi w_n int [2 eps(u):eps(v) - P div v - Q div u] r dr dz`, w_0 = 1, w_1 = 1/2 (angular means of 1 and cos^2),
/// with the strains of the harmonic (strain_operator.h).
///
/// Far field: the point-load solutions of Boussinesq and Cerruti in an incompressible half-space satisfy
/// `t = -(3 G / R)(u.n) n` on a hemisphere of radius R; added as a Robin term (with the
/// tilt of the straight mesh edges), it scales with the shear modulus like the rest.
/// Symmetric, indefinite. Rows of constrained dofs hold a 1 on the diagonal alone. Force per length for lengths in any
/// unit.
SparseMatrix assemble_stiffness(const HarmonicSpace& space);

/// The same without the dofs i of the nodes inside cells, which are eliminated cell by cell: over the skeleton dofs s
/// `K_ss - K_si K_ii^{-1} K_is`, the exact stiffness of a body without loads inside its cells.
/// K_ii is regular: displacements that vanish on the border of a cell strain it (Korn), and the gradient of a pressure
/// that vanishes there works on them. It gives every pressure a negative diagonal, where K_ss has none.
/// For Q3/Q2: 13 of 22 (n = 0) and 18 of 31 (n = 1) dofs of a cell remain.
///
/// share: what some of the cells contribute, over all dofs. The shares 0 to count - 1 add up to the whole, but for
/// roundoff; rows to which a share contributes nothing hold a 0 on their diagonal.
SparseMatrix assemble_skeleton_stiffness(const HarmonicSpace& space, const Share& share = {});

/// All dofs of a body from those of its skeleton, a column each: `x_i = -K_ii^{-1} K_is x_s` inside the cells.
Eigen::MatrixXd extend_into_cells(const HarmonicSpace& space, const Eigen::MatrixXd& skeleton);

}  // namespace fretval::fem
