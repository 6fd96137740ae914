#include "fem/full_contact/turning_slip.h"

#include <algorithm>

namespace fretval::fem {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector2d;

MatrixXd turning_slip(const MatrixXd& along_traction, const MatrixXd& traction, const MatrixXd& traction_before,
                      double fraction) {
  const Index m = traction.cols() / 2;
  const auto at = [m](const MatrixXd& field, Index i, Index j) { return Vector2d(field(i, j), field(i, m + j)); };
  MatrixXd aside(traction.rows(), traction.cols());
  for (Index j = 0; j < m; ++j)
    for (Index i = 0; i < traction.rows(); ++i) {
      const Vector2d now = at(traction, i, j).stableNormalized(), before = at(traction_before, i, j).stableNormalized();
      const double cosine = std::max(now.dot(before), 0.0);
      const Vector2d of_point = (0.5 - fraction) * cosine * at(along_traction, i, j).norm() * (now - before);
      aside(i, j) = of_point[0];
      aside(i, m + j) = of_point[1];
    }
  return aside;
}

}  // namespace fretval::fem
