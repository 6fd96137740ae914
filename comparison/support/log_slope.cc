#include "comparison/support/log_slope.h"

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
  const auto n = static_cast<double>(u.size());
  double mean_u = 0, mean_v = 0, product = 0, square = 0;
  for (std::size_t i = 0; i < u.size(); ++i) {
    mean_u += u[i] / n;
    mean_v += v[i] / n;
  }
  for (std::size_t i = 0; i < u.size(); ++i) {
    product += (u[i] - mean_u) * (v[i] - mean_v);
    square += (u[i] - mean_u) * (u[i] - mean_u);
  }
  return LogSlope{product / square, static_cast<int>(u.size())};
}

}  // namespace fretval
