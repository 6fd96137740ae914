#pragma once

#include <Eigen/Dense>
#include <vector>

#include "fem/full_contact/angular_grid.h"
#include "fem/full_contact/angular_transform.h"
#include "fem/full_contact/surface_compliance.h"
#include "fem/support/shared_matrix.h"

namespace fretval::fem {

/// A block of one Fourier order over consecutive amplitudes, n_components times n_rings rows. Where the odd parity has
/// the same block as the even one, it serves the amplitudes of both.
struct OrderBlock {
  Eigen::Index first, n_components;  ///< of the amplitudes
  SharedMatrix matrix;
  Eigen::Index to_copy = 0;  ///< from its first amplitude to the first of the other parity; 0: there is none

  [[nodiscard]] Eigen::Index n_copies() const { return to_copy == 0 ? 1 : 2; }
};

/// Response of a body of unit shear modulus to tractions (u_x, u_y) or to pressures (u into the body), which are fields
/// on rings x angles: n_rings rows, and a column for each kept angle, t_x before t_y. With the amplitudes T f of a
/// field f (amplitudes_of) and the blocks C of a SurfaceCompliance
///
///   K f = T^T C T f,
///
/// each entry of which is the mean displacement of a point times its area. Displacements are read by the same
/// amplitudes as the fields are made of, so that K is symmetric positive definite up to the highest harmonic, and f . K
/// f is the work of the tractions. The part of a displacement in a harmonic that the fields do not have is left out.
/// Length^3 per shear modulus. An application takes some n_orders x n_rings^2 operations.
class SurfaceOperator {
 public:
  /// Throws std::invalid_argument for a compliance that lacks orders which the grid draws on.
  SurfaceOperator(const SurfaceCompliance& surface, const AngularGrid& grid, SurfaceField field);

  /// The operator of the first n_rings rings alone.
  [[nodiscard]] SurfaceOperator leading(Eigen::Index n_rings) const;

  /// result <- K field.
  void apply(const Eigen::MatrixXd& field, Eigen::MatrixXd& result) const;

  [[nodiscard]] const AngularGrid& grid() const { return grid_; }
  [[nodiscard]] const std::vector<double>& radii() const { return radii_; }
  /// Per ring: the area that each of its kept points stands for, that of the points which a mirror leaves out included.
  [[nodiscard]] const Eigen::VectorXd& areas() const { return areas_; }
  [[nodiscard]] Eigen::Index n_rings() const { return areas_.size(); }
  [[nodiscard]] Eigen::Index n_columns() const { return transform_.n_columns(); }
  /// Per ring: the largest diagonal entry of K.
  [[nodiscard]] const Eigen::VectorXd& diagonal() const { return diagonal_; }
  /// T and T^T.
  [[nodiscard]] const AngularTransform<double>& transform() const { return transform_; }
  [[nodiscard]] const std::vector<OrderBlock>& blocks() const { return blocks_; }

 private:
  AngularGrid grid_;
  std::vector<double> radii_;
  Eigen::VectorXd areas_, diagonal_;
  AngularTransform<double> transform_;
  std::vector<OrderBlock> blocks_;
};

/// What pressures do along the surface and tractions across it: with the amplitudes of both and the blocks of a
/// SurfaceCompliance between them, X = T_t^T C_tz T_z and its transpose. With K of each field,
///
///   [ K_t   X  ] [ t ]
///   [ X^T  K_z ] [ p ]
///
/// is the response to both, symmetric positive definite. Units as of SurfaceOperator.
class CouplingOperator {
 public:
  /// Of a contact in which neither does anything.
  CouplingOperator() = default;
  /// Throws std::invalid_argument as SurfaceOperator does.
  CouplingOperator(const SurfaceCompliance& surface, const AngularGrid& grid);

  /// X p: areas times displacements along the surface by the pressures, n_rings x 2 n_angles.
  [[nodiscard]] Eigen::MatrixXd along_surface(const Eigen::MatrixXd& pressure) const;
  /// X^T t: areas times displacements into the body by the tractions, n_rings x n_angles.
  [[nodiscard]] Eigen::MatrixXd into_body(const Eigen::MatrixXd& traction) const;

 private:
  struct Block {
    Eigen::Index tangential, n_components;  ///< first amplitude of the tractions, and how many
    Eigen::Index normal;                    ///< amplitude of the pressures
    Eigen::MatrixXd matrix;                 ///< n_components times n_rings rows, n_rings columns
  };
  AngularTransform<double> tangential_, normal_;
  std::vector<Block> blocks_;
};

/// The inverse of K + D, in which points are tied to the ground by D, a stiffness per ring times the area of a point.
/// It is symmetric positive definite, and exact but for the highest harmonic of an even number of angles and for single
/// precision, in which its blocks take half of the time: a preconditioner of conjugate gradients.
class InverseOperator {
 public:
  /// ground: stiffness of each ring to the ground, not negative. Throws SolverError where a block is not positive
  /// definite.
  InverseOperator(const SurfaceOperator& op, const Eigen::VectorXd& ground);

  /// field: of as many rings as the operator had, or fewer; it is zero on the others, where the result is left out.
  void apply(const Eigen::MatrixXd& field, Eigen::MatrixXd& result) const;

 private:
  struct Block {
    Eigen::Index first, n_components, to_copy;  ///< as of OrderBlock
    Eigen::MatrixXf matrix;                     ///< the inverse over scale_, which keeps it within single precision
  };
  AngularTransform<float> fields_;  // its weights are the fields of unit amplitudes
  Eigen::Index n_rings_;
  double scale_;
  std::vector<Block> blocks_;
};

}  // namespace fretval::fem
