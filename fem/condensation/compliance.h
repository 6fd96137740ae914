#pragma once

#include <Eigen/Dense>
#include <memory>
#include <vector>

#include "fem/operators/harmonic_space.h"
#include "fem/support/shared_matrix.h"

namespace fretval::fem {

/// Response of the contact line of a body with unit shear modulus to piecewise constant pressure or traction.
///
/// `matrix(i, j)` = integral over ring i of the displacement due to a unit traction on ring j = `B^T S^{-1} B`, with
/// the Schur complement S and the ring loads B. Symmetric positive definite; for a modulus history G(t) it maps the
/// ring tractions to `int G(t-t') du/dt' dt'` (docs/theory.md). Length^3 per shear modulus.
struct Compliance {
  std::vector<double> radii;  ///< n + 1 ring radii
  Eigen::VectorXd areas;      ///< n ring areas
  SharedMatrix matrix;        ///< n x n; with several components n rows for each, one component after the other
  /// A half-space with the same rings, or, where rings are equal, with the innermost of them. It tells where the edge
  /// of a disc of rings lies, which is a local matter and so nearly the same on this body. Null: the body is a
  /// half-space itself.
  std::shared_ptr<const Compliance> half_space = {};
};

/// The compliance of a contact line. schur: S, in the order of line.dofs. Throws SolverError if it is not positive
/// definite.
Compliance contact_compliance(const ContactLine& line, const Eigen::MatrixXd& schur);

/// Of a body with all of its lengths larger by a factor: areas grow with its square, the matrix with its cube.
Compliance scaled(const Compliance& compliance, double factor);

/// Number of rings whose middle lies within a radius; where the radius is a node but for roundoff, the number of rings
/// up to that node.
Eigen::Index rings_within(const Compliance& compliance, double radius);

/// Lower Cholesky factor of the matrix of a compliance. Throws SolverError if it is not positive definite.
Eigen::MatrixXd cholesky_factor(const Eigen::MatrixXd& compliance);

}  // namespace fretval::fem
