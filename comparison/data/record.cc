#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparison/data/path_table.h"
#include "comparison/support/statistics.h"
#include "mdr/motion/mean_cycle.h"

namespace fretval {
namespace {

using Values = std::vector<double>;

constexpr double closing_roundoff = 1e-6, small_jump = 0.02;  // of the largest value, and of the range
constexpr double share_of_tolerance = 0.125;                  // of the tolerance on the stick radius goes to the path
constexpr double usual_tolerance = 1e-3;
constexpr std::size_t most_rows_kept = 1000;
constexpr double deviations = 4;  // of noise, that a row hardly exceeds

const char* unit_of(bool force) {
  return force ? "N" : "m";
}

/// Few rows are no record: what they jump by is no noise.
double noise_of(const Values& values) {
  constexpr std::size_t least_rows_of_record = 100;
  return values.size() < least_rows_of_record ? 0 : mdr::white_noise_of(values);
}

/// Rows before the contact: up to the last one without it ahead of the first that presses half as much as any.
std::size_t n_before_contact(const Case::Path& path) {
  const auto& normal = path.normal;
  const double none = path.normal_force ? deviations * noise_of(normal) : 0;
  if (normal.front() > none || normal.front() > 0.1 * largest_size(normal)) return 0;
  const double half = *std::max_element(normal.begin(), normal.end()) / 2;
  if (!(half > 0)) return 0;
  std::size_t row = 0;
  while (normal[row] < half) ++row;
  while (row > 0 && normal[row - 1] > none) --row;
  return row;
}

/// Replaces a row above the surface by the point at which the indenter touches, on the line to the next row.
void touch_on_line(std::size_t row, Case::Path& path) {
  const double above = path.normal[row], share = above / (above - path.normal[row + 1]);
  path.time[row] += share * (path.time[row + 1] - path.time[row]);
  path.tangential[row] += share * (path.tangential[row + 1] - path.tangential[row]);
  path.normal[row] = 0;
}

void drop_rows(std::size_t n, Case::Path& path) {
  for (auto* values : {&path.time, &path.normal, &path.tangential})
    values->erase(values->begin(), values->begin() + static_cast<std::ptrdiff_t>(n));
}

bool closes(const Values& values) {
  return std::abs(values.front() - values.back()) <= closing_roundoff * largest_size(values);
}

/// Closes a path: takes off a ramp over its time, so that the last row equals the first.
void close_by_ramp(const Values& time, Values& values) {
  const double jump = values.back() - values.front(), begin = time.front(), duration = time.back() - begin;
  for (std::size_t i = 0; i < values.size(); ++i) values[i] -= jump * (time[i] - begin) / duration;
  values.back() = values.front();
}

/// Closes a record that repeats but whose last row is not the first: by a ramp, or by its mean cycle.
void fold(Case::Path& path, Case::PathReduction& reduction, std::vector<std::string>& notes) {
  if (const auto mean = mdr::mean_cycle({path.time, path.normal, path.tangential})) {
    notes.push_back(fmt::format(
        "{}: folded to the mean of {} cycles of {:.6g} s, {} rows ahead of them are left out; from cycle to cycle the "
        "normal signal scatters by {:.2g} {}, the tangential one by {:.2g} {} (standard deviation)",
        path.file, mean->n_cycles, mean->period(), mean->n_before, mean->normal_scatter, unit_of(path.normal_force),
        mean->tangential_scatter, unit_of(path.tangential_force)));
    path.time = mean->cycle.time;
    path.normal = mean->cycle.normal;
    path.tangential = mean->cycle.tangential;
    reduction.n_cycles = mean->n_cycles;
    reduction.normal_scatter = mean->normal_scatter;
    reduction.tangential_scatter = mean->tangential_scatter;
    return;
  }
  const auto close_one = [&](const char* name, bool force, Values& values, double& error) {
    const double jump = values.front() - values.back();
    if (std::abs(jump) > small_jump * range_of(values) + deviations * noise_of(values))
      throw InputError(fmt::format(
          "{}: {} jumps by {:.4g} {}, from {:g} {} in the last row to {:g} {} in the first, where the path "
          "begins again, and the record shows no period that it could be folded to; must end where it "
          "begins, have two cycles or more, or have Motion / Path repeats = once",
          path.file, name, jump, unit_of(force), values.back(), unit_of(force), values.front(), unit_of(force)));
    error += std::abs(jump);
    close_by_ramp(path.time, values);
  };
  const double normal_jump = path.normal.front() - path.normal.back(),
               tangential_jump = path.tangential.front() - path.tangential.back();
  close_one(path.normal_force ? "F_N" : "d", path.normal_force, path.normal, reduction.normal_error);
  close_one(path.tangential_force ? "F_x" : "u_x", path.tangential_force, path.tangential, reduction.tangential_error);
  notes.push_back(
      fmt::format("{}: closed by a ramp over the jumps of {:.2g} {} and {:.2g} {} from its end to its "
                  "beginning",
                  path.file, normal_jump, unit_of(path.normal_force), tangential_jump, unit_of(path.tangential_force)));
}

double absolute(const PathTolerance& tolerance, bool force, double size) {
  const auto& given = force ? tolerance.force : tolerance.length;
  if (given) return *given;
  const double share = tolerance.relative > 0 ? tolerance.relative : share_of_tolerance * usual_tolerance;
  return share * size;
}

void reduce(const PathTolerance& tolerance, Case::Path& path, Case::PathReduction& reduction,
            std::vector<std::string>& notes) {
  const double tangential_size = range_of(path.tangential) / 2, normal_size = largest_size(path.normal);
  const std::size_t n = path.time.size();
  const auto kept = mdr::reduced(
      {path.time, path.normal, path.tangential}, absolute(tolerance, path.normal_force, normal_size),
      absolute(tolerance, path.tangential_force, tangential_size > 0 ? tangential_size : 1), most_rows_kept);
  path.time = kept.record.time;
  path.normal = kept.record.normal;
  path.tangential = kept.record.tangential;
  if (path.repeats) {
    close_by_ramp(path.time, path.normal);
    close_by_ramp(path.time, path.tangential);
  }
  reduction.normal_error += kept.normal_error;
  reduction.tangential_error += kept.tangential_error;
  notes.push_back(fmt::format("{}: {} of {} rows describe the record within {:.2g} {} and {:.2g} {}", path.file,
                              path.time.size(), n, kept.normal_error, unit_of(path.normal_force), kept.tangential_error,
                              unit_of(path.tangential_force)));
}

/// Leaves out the rows before the contact; how many. A single pass of displacements begins where the indenter comes to
/// touch, and so does one whose first indentation is no more than noise.
std::size_t cut_to_contact(Case::Path& path) {
  const auto n = n_before_contact(path);
  if (n + 2 >= path.time.size()) return 0;
  const bool is_pressed_in_once = !path.repeats && !path.normal_force,
             is_noise = is_pressed_in_once && path.normal.front() <= deviations * noise_of(path.normal);
  path.from_touch = !path.repeats && (n > 0 || is_noise);
  if (n == 0 || !is_pressed_in_once) {
    drop_rows(n, path);
    if (is_noise) path.normal.front() = 0;
    return n;
  }
  const bool is_a_row = path.normal[n - 1] == 0;
  touch_on_line(n - 1, path);
  drop_rows(n - 1, path);
  return is_a_row ? n - 1 : n;
}

/// Means of rows, which may begin above the surface or below it.
void touch_in_first_row(Case::Path& path) {
  if (!path.from_touch || path.normal_force) return;
  std::size_t first = 0;
  while (first + 1 < path.normal.size() && path.normal[first + 1] <= 0) ++first;
  if (first + 1 == path.normal.size()) return;
  if (path.normal[first + 1] > path.normal[first]) touch_on_line(first, path);
  drop_rows(first, path);
  path.normal.front() = 0;
}

/// Sets the first tangential force of a record to exactly 0 if it differs from it by noise alone.
void begin_at_zero(Case::Path& path) {
  if (!path.tangential_force || path.repeats) return;
  if (std::abs(path.tangential.front()) <= deviations * noise_of(path.tangential)) path.tangential.front() = 0;
}

}  // namespace

Case::Path path_of_record(Case::Path path, const PathTolerance& tolerance, std::vector<std::string>& notes) {
  Case::PathReduction reduction{path.time.size()};
  bool any = false;
  const bool has_period = !path.repeats || (closes(path.normal) && closes(path.tangential));
  if (!path.repeats || !has_period) {
    if (const auto n_cut = cut_to_contact(path); n_cut > 0) {
      notes.push_back(fmt::format("{}: {} rows before the contact, up to t = {:g} s, are cut off", path.file, n_cut,
                                  path.time.front()));
      reduction.n_cut = n_cut;
      any = true;
    }
  }
  begin_at_zero(path);
  if (!has_period) {
    fold(path, reduction, notes);
    any = true;
  }
  if (path.time.size() > most_rows_of_path || tolerance.is_given) {
    reduce(tolerance, path, reduction, notes);
    touch_in_first_row(path);
    begin_at_zero(path);
    any = true;
  }
  if (any) path.reduction = reduction;
  return path;
}

}  // namespace fretval
