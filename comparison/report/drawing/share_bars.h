#pragma once

#include <string>
#include <vector>

#include "comparison/report/text/render.h"

namespace fretval {

/// Of a quantity, the shares of each source.
struct ShareRow {
  std::string label;
  std::vector<double> shares;
};

/// Bars of shares that add up, a bar a row, as data of the page; a line marks 1.
Filling share_bars(const std::string& title, const std::string& label, const std::vector<std::string>& sources,
                   const std::vector<ShareRow>& rows);

/// Such bars where scripts are off.
std::string share_bars_svg(const Filling& bars);

}  // namespace fretval
