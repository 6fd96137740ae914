#pragma once

#include <istream>
#include <string>

#include "mdr/profiles/profile.h"

namespace fretval::mdr {

/// Reads a profile from the columns radius and height (see read_csv) and hands it to tabulated() with noise, the
/// standard deviation of the heights in m, or 0 for a profile through the points.
///
/// Units are those that the second header line names, or else the brackets in the names, "r [mm]": m, mm, um, µm or
/// nm. Without any they are m. The rows are a scan outwards: radii increase from line to line.
///
/// Throws std::invalid_argument that names the source, and for a bad row its line: radii that repeat or fall back, a
/// negative one, a first one off the axis with noise = 0, an unknown unit, and all that tabulated() refuses.
Profile read_profile_table(std::istream& stream, const std::string& source_name, double noise = 0);

}  // namespace fretval::mdr
