#include "comparison/case/noisy_start.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparison/support/quantile.h"
#include "mdr/motion/record_reduction.h"

namespace fretval {
namespace {

using Values = std::vector<double>;

constexpr std::size_t n_behind = 4, least_rows = 32;
constexpr double tolerance_of_none = 1e-3, far_off = 3;

/// The distance of row i from the line through those behind it.
double step_from_line(const Values& time, const Values& values, std::size_t i) {
  double mean_t = 0, mean_y = 0, tt = 0, ty = 0;
  for (std::size_t k = i + 1; k <= i + n_behind; ++k) {
    mean_t += time[k] / n_behind;
    mean_y += values[k] / n_behind;
  }
  for (std::size_t k = i + 1; k <= i + n_behind; ++k) {
    tt += (time[k] - mean_t) * (time[k] - mean_t);
    ty += (time[k] - mean_t) * (values[k] - mean_y);
  }
  return values[i] - mean_y - ty / tt * (time[i] - mean_t);
}

double usual_step(const Values& time, const Values& values) {
  Values sizes;
  for (std::size_t i = 1; i + n_behind < values.size(); ++i) sizes.push_back(std::abs(step_from_line(time, values, i)));
  return quantile(sizes, 0.5).value_or(0);
}

}  // namespace

std::vector<std::string> noisy_start(const Case::Path& path, double tolerance) {
  std::vector<std::string> warnings;
  const auto& reduction = path.reduction;
  const bool is_reduced = reduction && reduction->n_rows - reduction->n_cut > path.time.size();
  if (path.repeats || path.from_touch || is_reduced || path.time.size() < least_rows) return warnings;
  struct Column {
    const char* name;
    const Values& values;
    bool is_force;
  };
  for (const auto& [name, values, is_force] : {Column{path.normal_force ? "F_N" : "d", path.normal, path.normal_force},
                                               Column{"u_x", path.tangential, path.tangential_force}}) {
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    const double first = std::abs(step_from_line(path.time, values, 0)),
                 matters = (tolerance > 0 ? tolerance : tolerance_of_none) * (*most - *least);
    const double usual = usual_step(path.time, values), noise = mdr::white_noise_of(values);
    if (is_force || !(first > matters) || !(noise > matters || first > far_off * usual)) continue;
    warnings.push_back(fmt::format(
        "{}: {} = {:.4g} m in the first row is {:.2g} m off the line through the rows behind it (other rows: {:.2g} "
        "m): the body rests in the first row, and the whole answer moves with it; Motion / Path tolerance smooths the "
        "record, or begin it with the mean of a hold",
        path.file, name, values.front(), first, usual));
  }
  return warnings;
}

}  // namespace fretval
