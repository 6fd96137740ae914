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
/// integrals of the displacement over the rings; rows of W are such integrals for n = 0 and half of them for n >= 1, as
/// the mean of cos^2 is 1/2. Thus a block times tractions is work-conjugate to tractions. A traction on W points out of
/// the body. Length^3 per shear modulus.
struct SurfaceCompliance {
  std::vector<double> radii;         ///< n_rings + 1 ring radii
  Eigen::VectorXd areas;             ///< of the rings
  SharedMatrix torsion;              ///< order 0, odd
  std::vector<SharedMatrix> orders;  ///< [n]: block of the even field of order n; for n >= 1 that of the odd one, too

  [[nodiscard]] Eigen::Index n_rings() const { return areas.size(); }
  /// The block of an order, even or odd.
  [[nodiscard]] const Eigen::MatrixXd& of(const FourierOrder& order) const {
    return order.is_torsion() ? torsion : orders[order.n];
  }
};

/// One block: the compliance of all components of an order, n_rings rows each. It is exact for the total force of the
/// rings on a compressible half-space, too (add_far_field). degree: polynomial degree of the displacement. Throws
/// std::invalid_argument as HarmonicSpace does, and SolverError as Condensation does.
Compliance surface_block(const GridData& grid, const FourierOrder& order, unsigned degree = 3);

/// The compliance of the body that a grid describes, for the orders 0 to highest_order; each of them is one
/// surface_block.
SurfaceCompliance surface_compliance(const GridData& grid, unsigned highest_order, unsigned degree = 3);

/// The compliance of the ring contact: the rows and columns of ring_component(order) in the block of an order.
Compliance ring_compliance(const SurfaceCompliance& surface, const FourierOrder& order);

}  // namespace fretval::fem
