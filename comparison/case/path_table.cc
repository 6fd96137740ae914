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
const UnitSizes force_units{{"N", 1},     {"kN", 1e3},  {"MN", 1e6},  {"mN", 1e-3},
                            {"uN", 1e-6}, {"µN", 1e-6}, {"μN", 1e-6}, {"nN", 1e-9}};

constexpr double roundoff = 1e-6;
constexpr const char* example = R"("t,d,u_x" and "s,um,um", or "t,F_N,F_x" and "s,N,N")";

/// What a column may be named.
struct ColumnNames {
  const char* displacement;
  const char* force;  ///< null: none
};
constexpr std::array columns{ColumnNames{"t", nullptr}, ColumnNames{"d", "F_N"}, ColumnNames{"u_x", "F_x"}};

/// Without a unit in brackets.
std::string name_of_column(const mdr::CsvColumns& csv, std::size_t column) {
  const auto& name = csv.names[column];
  return trimmed(name.substr(0, name.find_first_of("[(")));
}

/// Whether each column is a force.
std::array<bool, columns.size()> forces_in(const std::string& file, const mdr::CsvColumns& csv) {
  std::array<bool, columns.size()> forces{};
  for (std::size_t column = 0; column < columns.size(); ++column) {
    if (!mdr::names_unit(csv, column))
      throw InputError(
          fmt::format("{}: column {} has no unit; must begin with a line of names and one of units, for example {}",
                      file, column + 1, example));
    const auto name = name_of_column(csv, column);
    const auto& [displacement, force] = columns[column];
    forces[column] = force && name == force;
    if (!forces[column] && name != displacement)
      throw InputError(fmt::format("{}: column {} is \"{}\", must be \"{}\"{}; the file begins for example with {}",
                                   file, column + 1, name, displacement, force ? fmt::format(" or \"{}\"", force) : "",
                                   example));
  }
  return forces;
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
  const auto close_one = [&](bool force, const ColumnNames& names, std::vector<double>& values) {
    const double jump = values.front() - values.back();
    const char* unit = force ? "N" : "m";
    if (std::abs(jump) > roundoff * largest_of(values))
      throw InputError(fmt::format(
          "{}: {} jumps by {:.4g} {}, from {:g} {} in the last row to {:g} {} in the first, where the path begins "
          "again; must end where it begins, or have Motion / Path repeats = once",
          file, force ? names.force : names.displacement, jump, unit, values.back(), unit, values.front(), unit));
    values.back() = values.front();
  };
  close_one(path.normal_force, columns[1], path.normal);
  close_one(path.tangential_force, columns[2], path.tangential);
}

void require_contact_at_rest(const std::string& file, const Case::Path& path) {
  const double rest = rest_of(path).normal;
  if (path.normal_force || rest > 0) return;
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

void require_pressing(const std::string& file, const mdr::CsvColumns& csv, const Case::Path& path) {
  for (std::size_t i = 0; path.normal_force && i < path.normal.size(); ++i)
    if (!(path.normal[i] > 0))
      throw InputError(fmt::format(
          "{}, line {}: F_N = {:g} N: must be positive: a normal force that pulls, or is none, is not balanced", file,
          csv.line_of_row[i], path.normal[i]));
}

/// To all digits.
void begin_without_tangential_force(const std::string& file, Case::Path& path) {
  if (!path.tangential_force || path.repeats) return;
  const double first = path.tangential.front();
  if (std::abs(first) > roundoff * largest_of(path.tangential))
    throw InputError(
        fmt::format("{}: F_x = {:g} N in the first row, must be 0: the body rests there without a tangential force "
                    "before the pass; begin with a row in which there is none",
                    file, first));
  path.tangential.front() = 0;
}

double half_range(const std::vector<double>& values) {
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return (*most - *least) / 2;
}

}  // namespace

PathRest rest_of(const Case::Path& path) {
  const auto at_rest = [&path](const std::vector<double>& values) {
    return path.repeats ? mean_over_time(path.time, values) : values.front();
  };
  return {at_rest(path.normal), path.tangential_force ? 0 : at_rest(path.tangential),
          path.transverse.empty() ? 0 : at_rest(path.transverse)};
}

Case::Path read_path_table(const std::string& file, bool repeats) {
  try {
    std::ifstream stream(file);
    auto csv = mdr::read_csv(stream, file, 3);
    const auto forces = forces_in(file, csv);
    const std::size_t n = csv.columns[0].size(), least = repeats ? 3 : 2;
    if (n < least)
      throw InputError(fmt::format("{}: {} {}; a path that {} needs at least {}", file, n, n == 1 ? "row" : "rows",
                                   repeats ? "repeats" : "is passed once", least));
    require_rising(file, csv);
    for (std::size_t column = 0; column < columns.size(); ++column) {
      const auto& units = column == 0 ? time_units : forces[column] ? force_units : mdr::length_units();
      const double size = mdr::unit_of_column(csv, column, units, file);
      for (double& value : csv.columns[column]) value *= size;
    }
    Case::Path path{
        file,     std::move(csv.columns[0]), std::move(csv.columns[1]), std::move(csv.columns[2]), repeats, forces[1],
        forces[2]};
    require_pressing(file, csv, path);
    if (repeats) close(file, path);
    require_contact_at_rest(file, path);
    begin_without_tangential_force(file, path);
    return path;
  } catch (const std::invalid_argument& error) {
    throw InputError(error.what());
  }
}

Case::Motion motion_along(Case::Path path) {
  Case::Motion motion;
  const double rest = rest_of(path).normal, normal = half_range(path.normal), tangential = half_range(path.tangential);
  if (path.normal_force) {
    motion.normal_force = Case::NormalForce{rest, normal};
  } else {
    motion.indentation = rest;
    motion.normal_amplitude = normal;
  }
  if (path.tangential_force)
    motion.tangential_force = tangential;
  else
    motion.tangential_amplitude = tangential;
  motion.normal_frequency = motion.tangential_frequency = 1 / path.duration();
  motion.phase = 0;
  motion.path = std::move(path);
  return motion;
}

}  // namespace fretval
