#pragma once

#include <Eigen/Dense>

#include "fem/operators/harmonic_space.h"
#include "fem/operators/sparse_matrix.h"

namespace fretval::fem {

/// Part `number` of `count` parts of the cells of a body, consecutive and about equally large.
struct Share {
  unsigned number = 0, count = 1;
};

/// Constants of the volume change of a body of unit shear modulus, in the mixed form of assemble_stiffness().
struct Compressibility {
  double shift;        ///< c = 2 (1 - 2 nu)/3
  double yielding;     ///< 1/(lambda + c), lambda = 2 nu/(1 - 2 nu); both are 0 for nu = 1/2
  double mean_stress;  ///< (lambda + 2/3)/(lambda + c), factor from -P to the mean stress; 1 for nu = 1/2
};

/// poisson_ratio: 0 to 1/2.
Compressibility compressibility(double poisson_ratio);

/// Stiffness of the body with unit shear modulus, mixed in displacement and pressure:
/// `2 pi w_n int [2 eps(u):eps(v) - c div u div v - P div v - Q div u - P Q/(lambda + c)] r dr dz`, with w_0 = 1 and
/// w_n = 1/2 else (angular means of 1 and cos^2), and the strains of the order (strain_operator.h). P is
/// -(lambda + c) div u; the share c of 2 eps:eps keeps the last term finite down to nu = 0, where lambda vanishes, and
/// is 0 where nu = 1/2. Moduli of cells multiply all of it but the two products of P and div, and divide P Q.
///
/// Far field: the point-load solutions of Boussinesq and Cerruti in an incompressible half-space satisfy `t = -(3 G /
/// R)(u.n) n` on a hemisphere of radius R, and a point couple about the axis, in torsion, `t = -(3 G / R) u`; added as
/// a Robin term (with the tilt of the straight mesh edges), it scales with the shear modulus like the rest. What this
/// condition lacks for nu < 1/2 is added to the compliance (fem/condensation/far_field.h). Symmetric, indefinite. Rows
/// of constrained dofs hold a 1 on the diagonal alone. Force per length for lengths in any unit.
SparseMatrix assemble_stiffness(const HarmonicSpace& space);

/// The stiffness without the dofs i of the nodes inside cells, which are eliminated cell by cell: `K_ss - K_si
/// K_ii^{-1} K_is` over the skeleton dofs s, the exact stiffness of a body without loads inside its cells. K_ii is
/// regular: displacements that vanish on the border of a cell strain it (Korn), and the gradient of a pressure that
/// vanishes there works on them. The elimination gives every pressure a negative diagonal, which K_ss does not have.
/// For Q3/Q2: 13 of 22 (n = 0) and 18 of 31 (n = 1) dofs of a cell remain.
///
/// share: the part of the cells whose contribution is returned, over all skeleton dofs. The shares 0 to count - 1 add
/// up to the whole, but for roundoff; rows to which a share contributes nothing hold a 0 on their diagonal.
SparseMatrix assemble_skeleton_stiffness(const HarmonicSpace& space, const Share& share = {});

/// All dofs of a body (n_dofs x columns) from those of its skeleton: `x_i = -K_ii^{-1} K_is x_s` inside the cells.
Eigen::MatrixXd extend_into_cells(const HarmonicSpace& space, const Eigen::MatrixXd& skeleton);

}  // namespace fretval::fem
