#pragma once

#include <Eigen/Dense>

#include "fem/operators/harmonic_space.h"
#include "fem/operators/sparse_matrix.h"

namespace fretval::fem {

/// One of so many parts of about as many cells, as they follow each other.
struct Share {
  unsigned number = 0, count = 1;
};

/// How a body of unit shear modulus changes its volume, in the mixed form below.
struct Compressibility {
  double shift;        ///< c = 2 (1 - 2 nu)/3
  double yielding;     ///< 1/(lambda + c), lambda = 2 nu/(1 - 2 nu); both are 0 for nu = 1/2
  double mean_stress;  ///< (lambda + 2/3)/(lambda + c), which makes the mean stress of -P; 1 for nu = 1/2
};

/// poisson_ratio: 0 to 1/2.
Compressibility compressibility(double poisson_ratio);

/// Stiffness of the body with unit shear modulus, mixed in displacement and pressure:
/// `2 pi w_n int [2 eps(u):eps(v) - c div u div v - P div v - Q div u - P Q/(lambda + c)] r dr dz`, with w_0 = 1 and
/// w_n = 1/2 else (angular means of 1 and cos^2), and the strains of the order (strain_operator.h). P is
/// -(lambda + c) div u; the share c of 2 eps:eps keeps the last term finite down to nu = 0, where lambda vanishes, and
/// is 0 where nu = 1/2. Moduli of cells multiply all of it but the two products of P and div, and divide P Q.
///
/// Far field: the point-load solutions of Boussinesq and Cerruti in an incompressible half-space satisfy
/// `t = -(3 G / R)(u.n) n` on a hemisphere of radius R, and a point couple about the axis, in torsion,
/// `t = -(3 G / R) u`; added as a Robin term (with the tilt of the straight mesh edges), it scales with the shear
/// modulus like the rest. What it lacks for nu < 1/2 is left to the compliance (fem/condensation/far_field.h).
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
