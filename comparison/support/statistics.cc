#include "comparison/support/statistics.h"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace fretval {

std::optional<double> quantile(std::vector<double> values, double share) {
  if (values.empty()) return std::nullopt;
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size())));
  const std::size_t place = rank == 0 ? 0 : rank - 1;
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(place), values.end());
  return values[place];
}

double largest_size(const std::vector<double>& values) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  return largest;
}

double range_of(const std::vector<double>& values) {
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return *most - *least;
}

std::vector<double> thinned(const std::vector<double>& values, std::size_t most) {
  const std::size_t stride = std::max<std::size_t>((values.size() + most - 1) / most, 1);
  std::vector<double> few;
  for (std::size_t i = 0; i < values.size(); i += stride) few.push_back(values[i]);
  return few;
}

double to_digits(double value, int digits) {
  return std::strtod(fmt::format("{:.{}g}", value, digits).c_str(), nullptr);
}

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

std::optional<double> cycles_until(const std::vector<double>& slips, double least) {
  const auto last = std::find_if(slips.rbegin(), slips.rend(), [least](double slip) { return slip > least; });
  if (last == slips.rbegin() || last == slips.rend()) return std::nullopt;
  const auto next = last.base();  // the first one that is not above it any more
  return static_cast<double>(next - slips.begin()) + (*last - least) / (*last - *next);
}

}  // namespace fretval
