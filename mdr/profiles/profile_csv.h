#pragma once

#include <istream>
#include <optional>
#include <string>
#include <vector>

#include "mdr/profiles/profile.h"
#include "mdr/profiles/two_sided_scan.h"

namespace fretval::mdr {

/// Rows from the apex outwards, in m.
struct ProfileRows {
  std::vector<double> r, f;
  std::optional<MeanOfHalves> halves = {};  ///< of a two-sided scan, whose mean the rows are
};

/// Reads the columns radius and height (see read_csv). noise: standard deviation of the heights in m; with 0 the scan
/// begins on the axis.
///
/// Units are those that the second header line names, or else the brackets in the names, "r [mm]": m, mm, um, µm or
/// nm. Without any they are m. Radii increase from line to line: a scan outwards or, if the first one is negative, a
/// scan through the apex at r = 0, of whose halves the mean is taken (two_sided_scan.h).
///
/// Throws std::invalid_argument that names the source, and for a bad row its line: radii that repeat or fall back, no
/// row on the axis with noise = 0, an unknown unit, halves that are not those of an axisymmetric body.
ProfileRows read_profile_rows(std::istream& stream, const std::string& source_name, double noise = 0);

/// The profile of such rows by tabulated(), through the points or, with noise, fitted to them. Throws what it refuses,
/// too.
Profile read_profile_table(std::istream& stream, const std::string& source_name, double noise = 0);

}  // namespace fretval::mdr
