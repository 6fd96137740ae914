#pragma once

#include <string>
#include <vector>

namespace fretval {

/// What each ring does over a period, radius over time, as a figure: white open, blue sticks, orange and yellow slip
/// forward and backward. radii: of the middles of the rings by area; unit: of the axis; zones: a text a step, a letter
/// a ring (see fem::WearingContact::Period::zone).
std::string zone_map_figure(const std::string& title, const std::vector<double>& radii, double unit,
                            const std::vector<std::string>& zones);

}  // namespace fretval
