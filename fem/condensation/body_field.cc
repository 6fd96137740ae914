#include "fem/condensation/body_field.h"

#include "fem/condensation/far_field.h"
#include "fem/operators/stiffness.h"
#include "fem/support/solver_error.h"

namespace fretval::fem {

Eigen::MatrixXd tractions_for(const Compliance& compliance, const Eigen::MatrixXd& ring_displacements) {
  const Eigen::LLT<Eigen::MatrixXd> factor(*compliance.matrix);
  if (factor.info() != Eigen::Success) throw SolverError("the contact compliance is not positive definite");
  return factor.solve(compliance.areas.asDiagonal() * ring_displacements);
}

Eigen::MatrixXd body_under(const HarmonicSpace& space, const Condensation& condensation,
                           const Eigen::MatrixXd& tractions) {
  const auto& line = space.contact_line();
  const Eigen::MatrixXd forces = line.loads * tractions;
  const bool lacks_far = lacks_far_field(space);
  Eigen::MatrixXd skeleton(space.n_skeleton_dofs(), tractions.cols());
  for (Eigen::Index k = 0; k < tractions.cols(); ++k) {
    Eigen::VectorXd rhs = Eigen::VectorXd::Zero(skeleton.rows());
    for (std::size_t i = 0; i < line.dofs.size(); ++i) rhs[line.dofs[i]] = forces(static_cast<Eigen::Index>(i), k);
    if (lacks_far) rhs += line.areas.dot(tractions.col(k)) * far_residual(space);
    if (rhs.isZero(0))
      skeleton.col(k).setZero();  // a residual has nothing to be relative to
    else
      skeleton.col(k) = condensation.solve(rhs);
  }
  return extend_into_cells(space, skeleton);
}

}  // namespace fretval::fem
