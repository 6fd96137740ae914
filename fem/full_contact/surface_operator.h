#pragma once

#include <Eigen/Dense>
#include <vector>

#include "fem/full_contact/angular_grid.h"
#include "fem/full_contact/surface_compliance.h"
#include "fem/support/shared_matrix.h"

namespace fretval::fem {

/// A block of one Fourier order over consecutive amplitudes, n_components times n_rings rows. It serves n_copies of
/// these amplitudes, one after the other, as the even and the odd parity have the same block.
struct OrderBlock {
  Eigen::Index first, n_components, n_copies;  ///< of the amplitudes
  SharedMatrix matrix;
};

/// Response of a body of unit shear modulus to fields on rings x angles: n_rings rows, and as many columns as there are
/// kept angles for each field, t_x before t_y before p. With the amplitudes T f of a field f (amplitudes_of) and the
/// blocks C of a SurfaceCompliance
///
///   K f = T^T C T f,
///
/// each entry of which is the mean displacement of a point times its area: (u_x, u_y) for t, and the displacement into
/// the body for p. Displacements are read by the same amplitudes as the fields are made of, so that K is symmetric
/// positive definite up to the highest harmonic, and f . K f is the work of the tractions. The part of a displacement
/// in a harmonic that the fields do not have is left out. Length^3 per shear modulus. An application takes some
/// n_orders x n_rings^2 operations.
class SurfaceOperator {
 public:
  /// coupling: whether pressures displace along the surface and tractions across it. Throws std::invalid_argument for a
  /// compliance that lacks orders which the grid draws on.
  SurfaceOperator(const SurfaceCompliance& surface, const AngularGrid& grid, Fields fields, bool coupling = true);

  /// The operator of the first n_rings rings alone.
  [[nodiscard]] SurfaceOperator leading(Eigen::Index n_rings) const;

  /// result <- K field.
  void apply(const Eigen::MatrixXd& field, Eigen::MatrixXd& result) const;

  [[nodiscard]] const AngularGrid& grid() const { return grid_; }
  [[nodiscard]] const std::vector<double>& radii() const { return radii_; }
  /// Per ring: the area that each of its kept points stands for, that of the points which a mirror leaves out included.
  [[nodiscard]] const Eigen::VectorXd& areas() const { return areas_; }
  [[nodiscard]] Eigen::Index n_rings() const { return areas_.size(); }
  [[nodiscard]] Eigen::Index n_columns() const { return transform_.rows(); }
  /// Per ring: the largest diagonal entry of K.
  [[nodiscard]] const Eigen::VectorXd& diagonal() const { return diagonal_; }
  /// T^T, a column for each amplitude.
  [[nodiscard]] const Eigen::MatrixXd& transform() const { return transform_; }
  [[nodiscard]] const std::vector<OrderBlock>& blocks() const { return blocks_; }

 private:
  AngularGrid grid_;
  std::vector<double> radii_;
  Eigen::VectorXd areas_, diagonal_;
  Eigen::MatrixXd transform_, transposed_;
  std::vector<OrderBlock> blocks_;
};

/// The inverse of K + D, in which points are tied to the ground by D, a stiffness per ring times the area of a point.
/// It is exact but for the highest harmonic of an even number of angles, and symmetric positive definite: a
/// preconditioner of conjugate gradients.
class InverseOperator {
 public:
  /// ground: stiffness of each ring to the ground, not negative. Throws SolverError where a block is not positive
  /// definite.
  InverseOperator(const SurfaceOperator& op, const Eigen::VectorXd& ground);

  void apply(const Eigen::MatrixXd& field, Eigen::MatrixXd& result) const;

 private:
  Eigen::MatrixXd fields_, transposed_;  // of unit amplitudes, a column each
  std::vector<OrderBlock> blocks_;       // inverses
};

}  // namespace fretval::fem
