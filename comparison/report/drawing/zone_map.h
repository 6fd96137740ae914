#pragma once

#include <string>
#include <vector>

#include "comparison/report/text/filling.h"

namespace fretval {

/// What each ring does over a period, radius over time, as data of the page: white open, blue sticks, orange and yellow
/// slip forward and backward. edges: outer radii of the rings, in the unit of the label; zones: a text for each step,
/// with a letter for each ring (see fem::WearingContact::Period::zone).
Filling zone_map(const std::string& title, const std::string& label, const std::vector<double>& edges,
                 const std::vector<std::string>& zones);

/// Outer edges of rings from the radii that halve their areas, over a unit.
std::vector<double> outer_edges(const std::vector<double>& radii, double unit);

}  // namespace fretval
