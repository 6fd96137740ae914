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
  if (n < 2 || path.indentation.size() != n || path.tangential.size() != n)
    throw std::invalid_argument("path: needs two rows at least, of as many times, indentations and displacements");
  for (const auto* column : {&path.time, &path.indentation, &path.tangential})
    for (const double value : *column) require_finite("path", value);
  for (std::size_t i = 1; i < n; ++i)
    if (!(path.time[i] > path.time[i - 1])) throw std::invalid_argument("path: times must rise from row to row");
  const bool closed =
      path.indentation.front() == path.indentation.back() && path.tangential.front() == path.tangential.back();
  if (path.repeats && !closed) throw std::invalid_argument("path: repeats, but does not end where it begins");
  require_positive("indentation at rest before the path", rest_position(path).indentation);
}

RestPosition rest_position(const SampledPath& path) {
  if (!path.repeats) return {path.indentation.front(), path.tangential.front()};
  return {mean_over_time(path.time, path.indentation), mean_over_time(path.time, path.tangential)};
}

double maximum_indentation(const SampledPath& path) {
  return *std::max_element(path.indentation.begin(), path.indentation.end());
}

}  // namespace fretval::mdr
