#include "fem/condensation/compliance.h"

#include "fem/support/solver_error.h"

namespace fretval::fem {

Compliance contact_compliance(const ContactLine& line, const Condensation& condensation) {
  const Eigen::LLT<Eigen::MatrixXd> factor(condensation.schur_complement());
  if (factor.info() != Eigen::Success)
    throw SolverError("the condensed stiffness of the contact line is not positive definite: the body is not held");
  const Eigen::MatrixXd half = factor.matrixL().solve(line.loads);
  Compliance compliance{line.radii, line.areas, half.transpose() * half};
  if (!compliance.matrix.allFinite()) throw SolverError("the compliance of the contact line is not finite");
  return compliance;
}

Eigen::MatrixXd cholesky_factor(const Compliance& compliance) {
  const Eigen::LLT<Eigen::MatrixXd> factor(compliance.matrix);
  if (factor.info() != Eigen::Success) throw SolverError("the contact compliance is not positive definite");
  return factor.matrixL();
}

}  // namespace fretval::fem
