#pragma once

#include <string>

#include "comparison/case/case.h"

namespace fretval {

/// Reads a path: CSV with the columns t, d or F_N, u_x or F_x in this order and a unit of each, in its second line or
/// in brackets. Two rows at least, three of a path that repeats, at instants that rise. A single pass begins in
/// contact, d > 0, and without tangential force, to 1e-6 of its largest |F_x|; a path that repeats has a positive mean
/// d over time, and ends where it began, to 1e-6 of its largest values. F_N is positive in every row. Throws InputError
/// with file, line and value.
Case::Path read_path_table(const std::string& file, bool repeats);

/// The motion along a path: with its size in the place of the entries that it replaces, see Case::Motion.
Case::Motion motion_along(Case::Path path);

/// Where the body rests before the motion, or under which forces, m or N: those of the first row of a single pass,
/// means over time of a path that repeats. A tangential force is none, and rises from there.
struct PathRest {
  double normal, tangential, transverse = 0;
};
PathRest rest_of(const Case::Path& path);

}  // namespace fretval
