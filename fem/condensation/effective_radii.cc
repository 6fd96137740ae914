#include "fem/condensation/effective_radii.h"

#include <algorithm>
#include <cmath>

namespace fretval::fem {
namespace {

bool has_equal_rings(const Compliance& compliance) {
  const auto& radii = compliance.radii;
  for (std::size_t m = 1; m < radii.size(); ++m)
    if (std::abs(radii[m] - radii[m - 1] - radii[1]) > 1e-9 * radii[1]) return false;
  return true;
}

}  // namespace

EffectiveRadii effective_radii(const Compliance& compliance) {
  const Eigen::Index n = compliance.areas.size();
  // Force of a unit indentation on rings 0..m-1 = |L_m^{-1} A_m|^2: one forward substitution serves every m.
  const Eigen::VectorXd half =
      cholesky_factor(compliance.matrix).triangularView<Eigen::Lower>().solve(compliance.areas);
  Eigen::VectorXd force(n + 1);
  Eigen::MatrixXd terms(n + 1, 3);
  force[0] = 0;
  terms.row(0).setZero();
  for (Eigen::Index m = 1; m <= n; ++m) {
    force[m] = force[m - 1] + half[m - 1] * half[m - 1];
    const double radius = compliance.radii[m], width = radius - compliance.radii[m - 1];
    terms.row(m) << radius, width, width * width / radius;
  }
  // The innermost discs are of too few rings. Under rings that differ, the third term would fit their differences.
  const Eigen::Index begin = n / 4, count = std::max<Eigen::Index>(n / 2, 3);
  const auto fitted = terms.middleRows(begin, count).leftCols(has_equal_rings(compliance) ? 3 : 2);
  const Eigen::VectorXd fit = fitted.colPivHouseholderQr().solve(force.segment(begin, count));
  const double scatter = (fitted * fit - force.segment(begin, count)).cwiseAbs().maxCoeff() / fit[0];
  return {force / fit[0], scatter};
}

}  // namespace fretval::fem
