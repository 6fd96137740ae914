#include "fem/condensation/compliance.h"

#include <cmath>

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

Compliance scaled(const Compliance& compliance, double factor) {
  const auto& [radii, areas, matrix, half_space] = compliance;
  Compliance larger{radii, std::pow(factor, 2) * areas, SharedMatrix(std::pow(factor, 3) * *matrix)};
  for (double& radius : larger.radii) radius *= factor;
  if (half_space) larger.half_space = std::make_shared<const Compliance>(scaled(*half_space, factor));
  return larger;
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
