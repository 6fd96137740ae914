#include "fem/full_contact/anderson_mixing.h"

namespace fretval::fem {

Eigen::VectorXd AndersonMixing::next(const Eigen::VectorXd& x, const Eigen::VectorXd& image) {
  const Eigen::VectorXd residual = image - x;
  if (residual_.size() > 0) {
    x_changes_.push_back(x - x_);
    residual_changes_.push_back(residual - residual_);
    if (x_changes_.size() > depth_) {
      x_changes_.erase(x_changes_.begin());
      residual_changes_.erase(residual_changes_.begin());
    }
  }
  x_ = x;
  residual_ = residual;
  const auto n = static_cast<Eigen::Index>(x_changes_.size());
  if (n == 0) return image;
  Eigen::MatrixXd of_x(x.size(), n), of_residual(x.size(), n);
  for (Eigen::Index i = 0; i < n; ++i) {
    of_x.col(i) = x_changes_[static_cast<std::size_t>(i)];
    of_residual.col(i) = residual_changes_[static_cast<std::size_t>(i)];
  }
  const Eigen::VectorXd gamma = of_residual.completeOrthogonalDecomposition().solve(residual);
  return image - (of_x + of_residual) * gamma;
}

}  // namespace fretval::fem
