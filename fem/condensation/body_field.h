#pragma once

#include <Eigen/Dense>

#include "fem/condensation/compliance.h"
#include "fem/condensation/condensation.h"
#include "fem/operators/harmonic_space.h"

namespace fretval::fem {

/// Ring tractions under which a body of unit shear modulus has these displacements on its rings, a column each.
Eigen::MatrixXd tractions_for(const Compliance& compliance, const Eigen::MatrixXd& ring_displacements);

/// All dofs of a body of unit shear modulus under ring tractions, a column each.
Eigen::MatrixXd body_under(const HarmonicSpace& space, const Condensation& condensation,
                           const Eigen::MatrixXd& tractions);

/// One harmonic of a viscoelastic body at an instant. With every modulus proportional to G(t) no history of the
/// interior is needed: its displacements follow those of the rings, its stresses the tractions at the instant, each as
/// in a body of unit shear modulus. All dofs of two such bodies, lengths, depths and tractions in units of their own.
struct HarmonicState {
  const HarmonicSpace& space;
  Eigen::VectorXd moved;     ///< has the displacements
  Eigen::VectorXd stressed;  ///< has the stresses
};

}  // namespace fretval::fem
