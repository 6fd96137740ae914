#pragma once

#include <string>
#include <vector>

#include "comparison/report/text/filling.h"

namespace fretval {

/// The shares of each source in the bar of a quantity.
struct ShareRow {
  std::string label;
  std::vector<double> shares;  ///< where negative, to the left
  double start = 0;            ///< where the first one begins
  double bar = 0;              ///< error bar about the end of the last one
};

/// Bars of shares that add up, one for each row, as data of the page; a line marks a limit. of_what: the unit of a
/// share, shown to a reader who points at it.
Filling share_bars(const std::string& title, const std::string& label, const std::vector<std::string>& sources,
                   const std::vector<ShareRow>& rows, double limit = 1,
                   const std::string& of_what = "of the tolerance");

}  // namespace fretval
