#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparison/case/case.h"

namespace fretval {

/// How far a path may be from the record of a rig that it stands for (Motion / Path tolerance).
struct PathTolerance {
  /// Relative tolerance, over the largest normal value and over half of the tangential range; used where no absolute
  /// one is given.
  double relative = 0;
  std::optional<double> length = {}, force = {};  ///< absolute, m and N
  bool is_given = false;                          ///< false: records of few rows are taken as they are
};

/// Largest number of rows of a path that finite elements step through without reduction.
constexpr std::size_t most_rows_of_path = 2000;

/// The record of a rig as a path: rows before the contact are cut off; a record that is to repeat and does not close
/// becomes its mean cycle (mdr/motion/mean_cycle.h), or closes by a ramp if it jumps by less than 2 % of its range; and
/// a record of more than most_rows_of_path rows, or with a tolerance, is reduced to the rows that the tolerance needs
/// (mdr/motion/record_reduction.h). A record that needs none of this is returned as it is. notes: what was done. Throws
/// InputError for a record that does not close and shows no period.
Case::Path path_of_record(Case::Path record, const PathTolerance& tolerance, std::vector<std::string>& notes);

/// Reads a path: a table with columns t, d or F_N, u_x or F_x, or u_y or F_y beside them, and a unit of each, wherever
/// they stand in it (see mdr/support/csv_columns.h). Two rows at least, three of a path that repeats, at instants that
/// rise. A record of a rig becomes a path as path_of_record says. After that, a single pass begins in contact, d > 0,
/// and without tangential force, to 1e-6 of its largest |F_x|; a path that repeats has a positive mean d over time. F_N
/// is positive in every row. notes: what was skipped and what was done. Throws InputError with file, line and value.
Case::Path read_path_table(const std::string& file, bool repeats, const PathTolerance& tolerance,
                           std::vector<std::string>& notes);

/// The motion along a path, whose size takes the place of the entries that it replaces, see Case::Motion.
Case::Motion motion_along(Case::Path path);

}  // namespace fretval
