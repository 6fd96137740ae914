#pragma once

#include <Eigen/Dense>

#include "fem/condensation/compliance.h"
#include "fem/condensation/condensation.h"
#include "fem/operators/harmonic_space.h"

namespace fretval::fem {

/// Ring tractions (n_rings x columns) under which a body of unit shear modulus has these ring displacements, column by
/// column.
Eigen::MatrixXd tractions_for(const Compliance& compliance, const Eigen::MatrixXd& ring_displacements);

/// Values of all dofs (n_dofs x columns) of a body of unit shear modulus under these ring tractions (n_rings x
/// columns).
Eigen::MatrixXd body_under(const HarmonicSpace& space, const Condensation& condensation,
                           const Eigen::MatrixXd& tractions);

/// One harmonic of a viscoelastic body at an instant. With every modulus proportional to G(t) no history of the
/// interior is needed: its displacements follow from those of the rings, its stresses from the tractions at the
/// instant, each as in a body of unit shear modulus. The two vectors are the dofs of two such bodies; lengths,
/// displacements and tractions have units of their own (FieldUnits).
struct HarmonicState {
  const HarmonicSpace& space;
  Eigen::VectorXd moved;     ///< n_dofs; its displacements are those of the body
  Eigen::VectorXd stressed;  ///< n_dofs; its stresses are those of the body
};

}  // namespace fretval::fem
