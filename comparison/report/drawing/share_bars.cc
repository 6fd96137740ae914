#include "comparison/report/drawing/share_bars.h"

namespace fretval {

Filling share_bars(const std::string& title, const std::string& label, const std::vector<std::string>& sources,
                   const std::vector<ShareRow>& rows, double limit, const std::string& of_what) {
  Filling bars{{"kind", "bars"},     {"title", title}, {"x_label", label},        {"sources", sources},
               {"of_what", of_what}, {"limit", limit}, {"rows", Filling::array()}};
  for (const auto& [name, shares, start, bar] : rows)
    bars["rows"].push_back({{"label", name}, {"shares", shares}, {"start", start}, {"bar", bar}});
  return bars;
}

}  // namespace fretval
