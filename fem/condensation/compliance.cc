#include "fem/condensation/compliance.h"

#include "fem/support/dense.h"
#include "fem/support/solver_error.h"

namespace fretval::fem {

Compliance contact_compliance(const ContactLine& line, const Eigen::MatrixXd& schur) {
  const auto factor = cholesky(schur);
  if (!factor)
    throw SolverError("the condensed stiffness of the contact line is not positive definite: the body is not held");
  Compliance compliance{line.radii, line.areas, gram(solve_lower(*factor, line.loads))};
  if (!compliance.matrix->allFinite()) throw SolverError("the compliance of the contact line is not finite");
  return compliance;
}

Eigen::Index rings_within(const Compliance& compliance, double radius) {
  const auto& radii = compliance.radii;
  std::size_t n = 0;
  while (n + 1 < radii.size() && (radii[n] + radii[n + 1]) / 2 < radius) ++n;
  return static_cast<Eigen::Index>(n);
}

Eigen::MatrixXd cholesky_factor(const Eigen::MatrixXd& compliance) {
  auto factor = cholesky(compliance);
  if (!factor) throw SolverError("the contact compliance is not positive definite");
  return *std::move(factor);
}

}  // namespace fretval::fem
