#include "fem/running_minimum.h"

#include <algorithm>
#include <limits>

namespace fretval::fem {

RunningMinimum::RunningMinimum(Eigen::Index n, double floor)
    : minimum_(Eigen::VectorXd::Constant(n, std::numeric_limits<double>::infinity())), floor_(floor) {}

void RunningMinimum::add(const Eigen::VectorXd& values) {
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    double candidate = values[i];
    if (n_samples_ >= 2 && last_[i] <= before_[i] && last_[i] <= values[i]) {
      const double curvature = values[i] - 2 * last_[i] + before_[i], slope = (values[i] - before_[i]) / 2;
      const double vertex = curvature > 0 ? last_[i] - slope * slope / (2 * curvature) : last_[i];
      candidate = std::min(values[i], std::max(vertex, floor_));
    }
    minimum_[i] = std::min(minimum_[i], candidate);
  }
  before_ = n_samples_ == 0 ? values : last_;
  last_ = values;
  ++n_samples_;
}

void RunningMinimum::restart() {
  minimum_.setConstant(std::numeric_limits<double>::infinity());
}

}  // namespace fretval::fem
