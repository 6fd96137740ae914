#pragma once

#include <istream>
#include <optional>
#include <string>
#include <vector>

#include "mdr/profiles/profile.h"
#include "mdr/profiles/two_sided_scan.h"
#include "mdr/support/csv_columns.h"

namespace fretval::mdr {

/// Rows from the apex outwards, in m.
struct ProfileRows {
  std::vector<double> r, f;
  std::optional<MeanOfHalves> halves = {};  ///< of a two-sided scan, of which the rows are the mean
};

/// What a table of heights has to have: radius and height.
const std::vector<WantedColumn>& profile_columns();

/// Reads radius and height, wherever they stand in a table (see read_columns), in this order where names do not tell.
/// noise: standard deviation of the heights in m; with 0 the scan
/// begins on the axis.
///
/// Units are m, cm, mm, um, µm or nm. Without any they are m. Radii increase from line to line: a scan outwards or, if
/// the first one is negative, a scan through the apex at r = 0, of whose halves the mean is taken (two_sided_scan.h).
///
/// Throws std::invalid_argument that names the source, and for a bad row its line: radii that repeat or fall back, no
/// row on the axis with noise = 0, an unknown unit, halves that are not those of an axisymmetric body.
ProfileRows read_profile_rows(std::istream& stream, const std::string& source_name, double noise = 0);

/// The profile of a table of heights: its rows, read as above, through tabulated(). Throws std::invalid_argument also
/// for what tabulated() refuses.
Profile read_profile_table(std::istream& stream, const std::string& source_name, double noise = 0);

}  // namespace fretval::mdr
