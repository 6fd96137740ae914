#pragma once

#include <Eigen/Dense>
#include <vector>

#include "fem/condensation/compliance.h"
#include "fem/operators/fourier_order.h"
#include "fem/operators/grid_data.h"
#include "fem/support/shared_matrix.h"

namespace fretval::fem {

/// Response of the contact line of a body with unit shear modulus to piecewise constant pressure and traction in any
/// direction, one symmetric positive definite block for each Fourier order of the displacement.
///
/// A block is the matrix of a Compliance over all components of its order (fem/operators/fourier_order.h), n_rings rows
/// each, one after the other: (U, W) of order 0, (s, m, W) of the others; torsion is V alone. Rows of U, V, s and m are
/// integrals of the displacement over the rings; those of W are that for n = 0 and half of it for n >= 1, as the mean
/// of cos^2 is 1/2: so a block times tractions is what they do work on. A traction on W points out of the body.
/// Length^3 per shear modulus.
struct SurfaceCompliance {
  std::vector<double> radii;         ///< n_rings + 1 ring radii
  Eigen::VectorXd areas;             ///< of the rings
  SharedMatrix torsion;              ///< order 0, odd
  std::vector<SharedMatrix> orders;  ///< [n]: even and, for n >= 1, odd, which has the same

  [[nodiscard]] Eigen::Index n_rings() const { return areas.size(); }
  /// The block of an order of either parity.
  [[nodiscard]] const Eigen::MatrixXd& of(const FourierOrder& order) const {
    return order.is_torsion() ? torsion : orders[order.n];
  }
};

/// One block: the compliance of all components of an order, n_rings rows each. Exact for the total force of the rings
/// over a compressible half-space too (add_far_field). degree: of the displacement. Throws std::invalid_argument as
/// HarmonicSpace does, and SolverError as Condensation does.
Compliance surface_block(const GridData& grid, const FourierOrder& order, unsigned degree = 3);

/// Of the body that a grid describes, of the orders 0 to highest_order; each of them is one surface_block.
SurfaceCompliance surface_compliance(const GridData& grid, unsigned highest_order, unsigned degree = 3);

/// What the ring contact needs of it: the component of the ring contact of an order, as a compliance of its own.
Compliance ring_compliance(const SurfaceCompliance& surface, const FourierOrder& order);

}  // namespace fretval::fem
