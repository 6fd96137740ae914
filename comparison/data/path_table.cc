#include "comparison/data/path_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>

#include "comparison/data/table_units.h"
#include "comparison/support/statistics.h"
#include "mdr/support/csv_columns.h"
#include "mdr/support/csv_units.h"

namespace fretval {
namespace {

constexpr double roundoff = 1e-6;
constexpr const char* example = R"("t,d,u_x" and "s,um,um", or "t,F_N,F_x" and "s,N,N")";

/// What a path has to have. Of a displacement and a force in one direction one alone can be prescribed.
const std::vector<mdr::WantedColumn>& path_columns() {
  const auto& rig = rig_columns();
  static const std::vector<mdr::WantedColumn> wanted{
      {{rig[0]}},
      {{rig[1], rig[3]}},
      {{rig[2], rig[4]}},
      {{{"transverse displacement u_y", {"uy", "transversedisp*"}, mdr::length_units()},
        {"transverse force F_y", {"fy", "transverseforce"}, mdr::force_units()}},
       true}};
  return wanted;
}

/// What a column is named in messages.
struct ColumnNames {
  const char* displacement;
  const char* force;  ///< null: none
};
constexpr std::array columns{ColumnNames{"t", nullptr}, ColumnNames{"d", "F_N"}, ColumnNames{"u_x", "F_x"}};

void require_names_and_units(const std::string& file, const mdr::ChosenColumns& chosen) {
  if (chosen.csv.names.empty())
    throw InputError(
        fmt::format("{}: has no names of columns; must begin with a line of names and one of units, for "
                    "example {}",
                    file, example));
  for (std::size_t column = 0; column < columns.size(); ++column)
    if (!mdr::names_unit(chosen.csv, column))
      throw InputError(
          fmt::format("{}: column {} has no unit; must begin with a line of names and one of units, for example {}",
                      file, chosen.csv.names[column], example));
}

void require_rising(const std::string& file, const mdr::CsvColumns& csv) {
  const auto& time = csv.columns[0];
  for (std::size_t i = 1; i < time.size(); ++i)
    if (!(time[i] > time[i - 1]))
      throw InputError(fmt::format("{}, line {}: t = {:g}: must be greater than that of the row before, {:g}", file,
                                   csv.line_of_row[i], time[i], time[i - 1]));
}

/// Makes the last row equal to the first to all digits.
void close(const std::string& file, Case::Path& path) {
  path.normal.back() = path.normal.front();
  path.tangential.back() = path.tangential.front();
  if (path.transverse.empty()) return;
  auto& across = path.transverse;
  if (std::abs(across.back() - across.front()) > roundoff * largest_size(across))
    throw InputError(fmt::format(
        "{0}: {1} jumps from {2:g} {4} in the last row to {3:g} {4} in the first, where the path begins "
        "again; must end where it begins, or have Motion / Path repeats = once",
        file, path.tangential_force ? "F_y" : "u_y", across.back(), across.front(), path.tangential_force ? "N" : "m"));
  across.back() = across.front();
}

/// The transverse column of a path, whose rows are taken as they are: a force beside a force.
std::vector<double> transverse_column(const std::string& file, mdr::ChosenColumns& chosen, bool beside_force) {
  constexpr std::size_t column = columns.size();
  if (!chosen.kind[column]) return {};
  const bool is_force = *chosen.kind[column] == 1;
  if (is_force != beside_force)
    throw InputError(
        fmt::format("{}: {} beside {}: along the surface both columns are displacements, u_x and u_y, or "
                    "both forces, F_x and F_y",
                    file, is_force ? "F_y" : "u_y", beside_force ? "F_x" : "u_x"));
  if (!mdr::names_unit(chosen.csv, column))
    throw InputError(
        fmt::format("{}: column {} has no unit; expected one, for example \"t,d,u_x,u_y\" and "
                    "\"s,um,um,um\"",
                    file, is_force ? "F_y" : "u_y"));
  return std::move(chosen.csv.columns[column]);
}

/// A single pass that begins as the indenter comes to touch begins so little deeper that the body bears nothing yet: a
/// start in contact takes no case of its own.
void begin_in_contact(Case::Path& path) {
  constexpr double share_of_the_deepest = 1e-9;
  if (path.normal_force || path.repeats || path.normal.front() != 0) return;
  path.from_touch = true;
  path.normal.front() = share_of_the_deepest * largest_size(path.normal);
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

/// lines: line of each row in the file.
void require_pressing(const std::string& file, const std::vector<int>& lines, const Case::Path& path) {
  for (std::size_t i = 0; path.normal_force && i < path.normal.size(); ++i)
    if (!(path.normal[i] > 0))
      throw InputError(fmt::format(
          "{}{}: F_N = {:g} N: must be positive: a normal force that pulls, or is none, is not balanced", file,
          path.reduction ? fmt::format(", t = {:g} s", path.time[i]) : fmt::format(", line {}", lines[i]),
          path.normal[i]));
}

/// Sets the first tangential force of a single pass to exactly 0.
void begin_without_tangential_force(const std::string& file, Case::Path& path) {
  if (!path.tangential_force || path.repeats) return;
  const double largest = std::max(largest_size(path.tangential), largest_size(path.transverse));
  const auto begin = [&](const char* name, std::vector<double>& forces) {
    if (forces.empty()) return;
    if (std::abs(forces.front()) > roundoff * largest)
      throw InputError(
          fmt::format("{}: {} = {:g} N in the first row, must be 0: the body rests there without a tangential force "
                      "before the pass; begin with a row in which there is none",
                      file, name, forces.front()));
    forces.front() = 0;
  };
  begin("F_x", path.tangential);
  begin("F_y", path.transverse);
}

}  // namespace

Case::Path read_path_table(const std::string& file, bool repeats, const PathTolerance& tolerance,
                           std::vector<std::string>& notes) {
  return input_from(file, [&] {
    std::ifstream stream(file);
    auto chosen = mdr::read_columns(stream, file, path_columns(), mdr::InOrder::no);
    auto& csv = chosen.csv;
    require_names_and_units(file, chosen);
    const std::size_t n = csv.columns[0].size(), least = repeats ? 3 : 2;
    if (n < least)
      throw InputError(fmt::format("{}: {} {}; a path that {} needs at least {}", file, n, n == 1 ? "row" : "rows",
                                   repeats ? "repeats" : "is passed once", least));
    require_rising(file, csv);
    take_into_si(file, path_columns(), chosen);
    if (auto skipped = skipped_text(file, chosen); !skipped.empty()) notes.push_back(std::move(skipped));
    const auto is_force = [&](std::size_t column) { return chosen.kind[column] == std::optional<std::size_t>(1); };
    auto transverse = transverse_column(file, chosen, is_force(2));
    const bool as_it_is = !transverse.empty();
    Case::Path rows{{std::move(csv.columns[0]), std::move(csv.columns[1]), std::move(csv.columns[2]), repeats,
                     is_force(1), is_force(2), std::move(transverse)},
                    file};
    auto path = as_it_is ? std::move(rows) : path_of_record(std::move(rows), tolerance, notes);
    require_pressing(file, csv.line_of_row, path);
    if (repeats) close(file, path);
    begin_in_contact(path);
    require_contact_at_rest(file, path);
    begin_without_tangential_force(file, path);
    return path;
  });
}

Case::Motion motion_along(Case::Path path) {
  Case::Motion motion;
  const double rest = rest_of(path).normal, normal = range_of(path.normal) / 2,
               tangential = range_of(path.tangential) / 2;
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
