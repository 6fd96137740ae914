#pragma once

#include <deal.II/fe/fe_values.h>

#include <Eigen/Dense>
#include <vector>

#include "fem/operators/harmonic_space.h"
#include "fem/operators/harmonic_space_parts.h"

namespace fretval::fem {

/// Operators of one cell at its quadrature points, for the few files that integrate stresses over the body, one column
/// per shape function of the displacement (all components of a node, then those of the next one) or of the pressure.
/// The stiffness is `strain^T strain + far^T far` of displacements, and `-divergence^T pressure` between them and
/// pressures.
///
/// Every row carries the square root of the weight of its point, `sqrt(2 pi w_n r JxW)`, w_0 = 1, w_1 = 1/2, so that
/// the product of two rows is a share of an integral. The rows of all points of a cell are stacked in one matrix, so
/// that a cell costs a few matrix products.
class CellOperators {
 public:
  explicit CellOperators(const HarmonicSpace& space);

  void evaluate(const dealii::DoFHandler<2>::active_cell_iterator& cell);

  /// Indices in the element of the shape functions to which the columns belong.
  [[nodiscard]] const std::vector<unsigned>& displacement_shapes() const { return displacement_shapes_; }
  [[nodiscard]] const std::vector<unsigned>& pressure_shapes() const { return pressure_shapes_; }

  /// sqrt(2) times the strain, 6 rows a point (rr, tt, zz and the tensor shears times sqrt(2)): its square is 2
  /// eps:eps.
  [[nodiscard]] const Eigen::MatrixXd& strain() const { return strain_; }
  [[nodiscard]] const Eigen::MatrixXd& divergence() const { return divergence_; }
  [[nodiscard]] const Eigen::MatrixXd& pressure() const { return pressure_; }

  /// sqrt(3/R) times the normal displacement u.n at the points of the far faces, see assemble_stiffness; no row in the
  /// other cells.
  [[nodiscard]] const Eigen::MatrixXd& far() const { return far_; }

 private:
  void append_far_face();

  FourierOrder order_;
  dealii::FEValues<2> values_;
  dealii::FEFaceValues<2> face_values_;
  std::vector<unsigned> displacement_shapes_, pressure_shapes_;
  Eigen::MatrixXd strain_, divergence_, pressure_, far_;
};

}  // namespace fretval::fem
