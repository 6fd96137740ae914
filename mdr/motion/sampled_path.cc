#include "mdr/motion/sampled_path.h"

#include <algorithm>
#include <stdexcept>

#include "mdr/support/checks.h"

namespace fretval::mdr {
namespace {

double mean_over_time(const std::vector<double>& time, const std::vector<double>& values) {
  double sum = 0;
  for (std::size_t i = 1; i < time.size(); ++i) sum += (time[i] - time[i - 1]) * (values[i - 1] + values[i]) / 2;
  return sum / (time.back() - time.front());
}

}  // namespace

void validate(const SampledPath& path) {
  const auto n = path.time.size();
  if (n < 2 || path.normal.size() != n || path.tangential.size() != n)
    throw std::invalid_argument("path: needs two rows at least, of as many times as values in either direction");
  for (const auto* column : {&path.time, &path.normal, &path.tangential})
    for (const double value : *column) require_finite("path", value);
  for (std::size_t i = 1; i < n; ++i)
    if (!(path.time[i] > path.time[i - 1])) throw std::invalid_argument("path: times must rise from row to row");
  if (!path.transverse.empty() && path.transverse.size() != n)
    throw std::invalid_argument("path: needs as many values across as along");
  for (const double value : path.transverse) require_finite("path", value);
  const bool closed = path.normal.front() == path.normal.back() && path.tangential.front() == path.tangential.back();
  if (path.repeats && !closed) throw std::invalid_argument("path: repeats, but does not end where it begins");
  if (path.normal_force)
    for (const double force : path.normal) require_positive("normal force along the path", force);
  else
    require_positive("indentation at rest before the path", rest_of(path).normal);
  if (path.tangential_force && !path.repeats && path.tangential.front() != 0)
    throw std::invalid_argument("path: a pass begins without tangential force, must be 0 in the first row");
}

PathRest rest_of(const SampledPath& path) {
  const auto at_rest = [&path](const std::vector<double>& values) {
    return path.repeats ? mean_over_time(path.time, values) : values.front();
  };
  return {at_rest(path.normal), path.tangential_force ? 0 : at_rest(path.tangential),
          path.transverse.empty() || path.tangential_force ? 0 : at_rest(path.transverse)};
}

double maximum_normal(const SampledPath& path) {
  return *std::max_element(path.normal.begin(), path.normal.end());
}

}  // namespace fretval::mdr
