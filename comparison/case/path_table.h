#pragma once

#include <string>

#include "comparison/case/case.h"

namespace fretval {

/// Reads a path: CSV with the columns t, d, u_x in this order and a unit of each, in its second line or in brackets.
/// Two rows at least, three of a path that repeats, at instants that rise. A single pass begins in contact, d > 0; a
/// path that repeats has a positive mean d over time, and ends where it began, to 1e-6 of its largest |d| and |u_x|.
/// Throws InputError with file, line and value.
Case::Path read_path_table(const std::string& file, bool repeats);

/// The motion along a path: with its size in the place of the entries that it replaces, see Case::Motion.
Case::Motion motion_along(Case::Path path);

/// Where the body rests before the motion, m: at the first row of a single pass, at the mean over time of a path that
/// repeats.
struct PathRest {
  double indentation, tangential;
};
PathRest rest_of(const Case::Path& path);

}  // namespace fretval
