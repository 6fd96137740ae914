#pragma once

#include <istream>
#include <string>
#include <vector>

#include "mdr/profiles/profile.h"

namespace fretval::mdr {

/// Rows of a scan outwards, in m.
struct ProfileRows {
  std::vector<double> r, f;
};

/// Reads the columns radius and height (see read_csv). noise: standard deviation of the heights in m; with 0 the scan
/// begins on the axis.
///
/// Units are those that the second header line names, or else the brackets in the names, "r [mm]": m, mm, um, µm or
/// nm. Without any they are m. The rows are a scan outwards: radii increase from line to line.
///
/// Throws std::invalid_argument that names the source, and for a bad row its line: radii that repeat or fall back, a
/// negative one, a first one off the axis with noise = 0, an unknown unit.
ProfileRows read_profile_rows(std::istream& stream, const std::string& source_name, double noise = 0);

/// The profile of such rows by tabulated(), through the points or, with noise, fitted to them. Throws what it refuses,
/// too.
Profile read_profile_table(std::istream& stream, const std::string& source_name, double noise = 0);

}  // namespace fretval::mdr
