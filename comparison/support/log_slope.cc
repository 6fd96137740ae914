#include "comparison/support/log_slope.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>

namespace fretval {

std::optional<LogSlope> log_slope(const std::vector<double>& x, const std::vector<double>& y, double floor) {
  std::vector<double> u, v;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!(x[i] > 0) || !(y[i] > floor) || !std::isfinite(y[i])) continue;
    u.push_back(std::log(x[i]));
    v.push_back(std::log(y[i]));
  }
  if (u.empty() || *std::min_element(u.begin(), u.end()) == *std::max_element(u.begin(), u.end())) return std::nullopt;
  const auto n = static_cast<Eigen::Index>(u.size());
  const Eigen::Map<const Eigen::ArrayXd> abscissae(u.data(), n), ordinates(v.data(), n);
  const Eigen::ArrayXd off = abscissae - abscissae.mean();
  return LogSlope{(off * (ordinates - ordinates.mean())).sum() / off.square().sum(), static_cast<int>(n)};
}

}  // namespace fretval
