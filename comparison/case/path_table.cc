#include "comparison/case/path_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <map>

#include "comparison/case/trimmed.h"
#include "mdr/support/csv_units.h"

namespace fretval {
namespace {

using UnitSizes = std::map<std::string, double>;
const UnitSizes time_units{{"s", 1}, {"ms", 1e-3}, {"us", 1e-6}, {"µs", 1e-6}, {"min", 60}, {"h", 3600}};
const UnitSizes length_units{{"m", 1}, {"mm", 1e-3}, {"um", 1e-6}, {"µm", 1e-6}, {"μm", 1e-6}, {"nm", 1e-9}};

constexpr const char* example = R"("t,d,u_x" and "s,um,um")";

/// Without a unit in brackets.
std::string name_of_column(const mdr::CsvColumns& csv, std::size_t column) {
  const auto& name = csv.names[column];
  return trimmed(name.substr(0, name.find_first_of("[(")));
}

void require_columns(const std::string& file, const mdr::CsvColumns& csv) {
  constexpr std::array names{"t", "d", "u_x"};
  for (std::size_t column = 0; column < names.size(); ++column) {
    if (!mdr::names_unit(csv, column))
      throw InputError(
          fmt::format("{}: column {} has no unit; must begin with a line of names and one of units, for example {}",
                      file, column + 1, example));
    const auto name = name_of_column(csv, column);
    if (name == "F_N" || name == "F_x")
      throw InputError(
          fmt::format("{}: column {} is \"{}\": forces along a path are not computed; expected the displacements t, d, "
                      "u_x. Oscillating forces are: Motion / Normal force, Tangential force amplitude",
                      file, column + 1, name));
    if (name != names[column])
      throw InputError(fmt::format("{}: column {} is \"{}\", must be \"{}\"; the file begins for example with {}", file,
                                   column + 1, name, names[column], example));
  }
}

void require_rising(const std::string& file, const mdr::CsvColumns& csv) {
  const auto& time = csv.columns[0];
  for (std::size_t i = 1; i < time.size(); ++i)
    if (!(time[i] > time[i - 1]))
      throw InputError(fmt::format("{}, line {}: t = {:g}: must be greater than that of the row before, {:g}", file,
                                   csv.line_of_row[i], time[i], time[i - 1]));
}

double largest_of(const std::vector<double>& values) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  return largest;
}

double mean_over_time(const std::vector<double>& time, const std::vector<double>& values) {
  double sum = 0;
  for (std::size_t i = 1; i < time.size(); ++i) sum += (time[i] - time[i - 1]) * (values[i - 1] + values[i]) / 2;
  return sum / (time.back() - time.front());
}

/// Makes the last row the first to all digits.
void close(const std::string& file, Case::Path& path) {
  constexpr double roundoff = 1e-6;
  const auto close_one = [&](const char* name, std::vector<double>& values) {
    const double jump = values.front() - values.back();
    if (std::abs(jump) > roundoff * largest_of(values))
      throw InputError(fmt::format(
          "{}: {} jumps by {:.4g} m, from {:g} m in the last row to {:g} m in the first, where the path begins "
          "again; must end where it begins, or have Motion / Path repeats = once",
          file, name, jump, values.back(), values.front()));
    values.back() = values.front();
  };
  close_one("d", path.indentation);
  close_one("u_x", path.tangential);
}

void require_contact_at_rest(const std::string& file, const Case::Path& path) {
  const double rest = rest_of(path).indentation;
  if (rest > 0) return;
  if (path.repeats)
    throw InputError(
        fmt::format("{}: the mean of d over time is {:g} m, must be positive: the body rests there before "
                    "the motion begins to rise",
                    file, rest));
  throw InputError(
      fmt::format("{}: d = {:g} m in the first row, must be positive: the body rests there, in contact and "
                  "without a tangential force, before the pass; begin with the first row in contact",
                  file, rest));
}

double half_range(const std::vector<double>& values) {
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return (*most - *least) / 2;
}

}  // namespace

PathRest rest_of(const Case::Path& path) {
  if (!path.repeats) return {path.indentation.front(), path.tangential.front()};
  return {mean_over_time(path.time, path.indentation), mean_over_time(path.time, path.tangential)};
}

Case::Path read_path_table(const std::string& file, bool repeats) {
  try {
    std::ifstream stream(file);
    auto csv = mdr::read_csv(stream, file, 3);
    require_columns(file, csv);
    const std::size_t n = csv.columns[0].size(), least = repeats ? 3 : 2;
    if (n < least)
      throw InputError(fmt::format("{}: {} {}; a path that {} needs at least {}", file, n, n == 1 ? "row" : "rows",
                                   repeats ? "repeats" : "is passed once", least));
    require_rising(file, csv);
    for (std::size_t column = 0; column < 3; ++column) {
      const double size = mdr::unit_of_column(csv, column, column == 0 ? time_units : length_units, file);
      for (double& value : csv.columns[column]) value *= size;
    }
    Case::Path path{file, std::move(csv.columns[0]), std::move(csv.columns[1]), std::move(csv.columns[2]), repeats};
    if (repeats) close(file, path);
    require_contact_at_rest(file, path);
    return path;
  } catch (const std::invalid_argument& error) {
    throw InputError(error.what());
  }
}

Case::Motion motion_along(Case::Path path) {
  Case::Motion motion;
  motion.indentation = rest_of(path).indentation;
  motion.normal_amplitude = half_range(path.indentation);
  motion.tangential_amplitude = half_range(path.tangential);
  motion.normal_frequency = motion.tangential_frequency = 1 / path.duration();
  motion.phase = 0;
  motion.path = std::move(path);
  return motion;
}

}  // namespace fretval
