#include "comparison/case/table_noise.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <stdexcept>

#include "comparison/support/statistics.h"
#include "mdr/motion/record_reduction.h"
#include "mdr/profiles/profile.h"
#include "mdr/profiles/profile_csv.h"

namespace fretval {
namespace {

using Values = std::vector<double>;

/// Residual of the middle one of five rows from the cubic through its neighbours, over its standard deviation for
/// heights of standard deviation 1.
double scaled_residual(const double* r, const double* f) {
  constexpr std::array<std::size_t, 4> others{0, 1, 3, 4};
  double value = f[2], square = 1;
  for (const auto i : others) {
    double weight = 1;
    for (const auto k : others)
      if (k != i) weight *= (r[2] - r[k]) / (r[i] - r[k]);
    value -= weight * f[i];
    square += weight * weight;
  }
  return value / std::sqrt(square);
}

/// Standard deviation of heights around a smooth curve; 0 for few rows. Kinks are few, and a median does not see them.
double noise_of_heights(const std::vector<double>& r, const std::vector<double>& f) {
  constexpr std::size_t least_rows = 16, width = 5;
  constexpr double deviation_over_median = 1.4826;  // of a normal distribution
  if (r.size() < least_rows) return 0;
  std::vector<double> sizes;
  for (std::size_t i = 0; i + width <= r.size(); ++i) sizes.push_back(std::abs(scaled_residual(&r[i], &f[i])));
  return deviation_over_median * quantile(sizes, 0.5).value_or(0);
}

double to_one_digit(double value) {
  const double digit = std::pow(10, std::floor(std::log10(value)));
  return digit * std::round(value / digit);
}

bool is_explained_by(double noise, const mdr::ProfileRows& rows) try {
  return mdr::falls_of_image(mdr::tabulated(rows.r, rows.f, noise)).empty();
} catch (const std::invalid_argument&) {
  return false;
}

constexpr std::size_t n_behind = 4, least_rows_of_path = 32;
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

std::optional<double> noise_behind_falls(const Case::Indenter& indenter) {
  if (indenter.table.empty() || indenter.trace || indenter.table_noise > 0) return std::nullopt;
  std::ifstream stream(indenter.table);
  const auto rows = mdr::read_profile_rows(stream, indenter.table);
  if (is_explained_by(0, rows)) return std::nullopt;
  const double noise = noise_of_heights(rows.r, rows.f);
  if (!(noise > 0)) return std::nullopt;
  for (const double candidate : {to_one_digit(noise), to_one_digit(1.5 * noise)})
    if (is_explained_by(candidate, rows)) return candidate;
  return std::nullopt;
}

std::string noise_text(double noise) {
  constexpr std::array<std::pair<const char*, double>, 4> units{{{"nm", 1e-9}, {"um", 1e-6}, {"mm", 1e-3}, {"m", 1}}};
  auto unit = units.front();
  for (const auto& one : units)
    if (noise >= 0.1 * one.second) unit = one;
  const auto text = fmt::format("{:.3g} {}", noise / unit.second, unit.first);
  return fmt::format(
      "it looks like noise of {0}: set Indenter / Table noise = {0}, and a convex profile is fitted, which MDR holds "
      "for",
      text);
}

std::vector<std::string> noisy_start(const Case::Path& path, double tolerance) {
  std::vector<std::string> warnings;
  const auto& reduction = path.reduction;
  const bool is_reduced = reduction && reduction->n_rows - reduction->n_cut > path.time.size();
  if (path.repeats || path.from_touch || is_reduced || path.time.size() < least_rows_of_path) return warnings;
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
