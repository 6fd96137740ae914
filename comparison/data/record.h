#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparison/case/case.h"

namespace fretval {

/// How far a path may be from the record of a rig that it stands for (Motion / Path tolerance).
struct PathTolerance {
  /// Over the largest normal value and over half of what lies between the tangential extremes; where no absolute one is
  /// given.
  double relative = 0;
  std::optional<double> length = {}, force = {};  ///< absolute, m and N
  bool is_given = false;                          ///< false: records of few rows are taken as they are
};

/// Rows of a path that finite elements step through as they are.
constexpr std::size_t most_rows_of_path = 2000;

/// The record of a rig as a path: rows before the contact are cut off; a record that is to repeat and does not close
/// becomes its mean cycle (mdr/motion/mean_cycle.h), or closes by a ramp if it jumps by less than 2 % of its range; and
/// of more than most_rows_of_path rows, or with a tolerance, so many are kept as the tolerance needs
/// (mdr/motion/record_reduction.h). A path that needs none of that is returned as it is. notes: what was done. Throws
/// InputError for a record that does not close and shows no period.
Case::Path path_of_record(Case::Path record, const PathTolerance& tolerance, std::vector<std::string>& notes);

}  // namespace fretval
