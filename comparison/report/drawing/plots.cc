#include "comparison/report/drawing/plots.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdlib>

namespace fretval {
namespace {

/// In the order of the enumeration.
constexpr std::array style_names{"line",   "dashed",       "thin line",   "line points",
                                 "points", "small points", "open points", "triangles"};

std::vector<double> rounded(std::vector<double> values) {
  for (double& value : values)
    if (std::isfinite(value)) value = std::strtod(fmt::format("{:.6g}", value).c_str(), nullptr);
  return values;
}

}  // namespace

Filling json_of(const Plot& plot) {
  Filling json{{"title", plot.title},
               {"x_label", plot.x_label},
               {"y_label", plot.y_label},
               {"log_x", plot.log_x},
               {"log_y", plot.log_y}};
  if (plot.x_range) json["x_range"] = {plot.x_range->first, plot.x_range->second};
  if (plot.y_range) json["y_range"] = {plot.y_range->first, plot.y_range->second};
  if (plot.equal_scales) json["equal_scales"] = true;
  if (!plot.x_tics.empty()) json["x_tics"] = plot.x_tics;
  for (const auto& [name, x] : plot.marks) json["marks"].push_back({{"name", name}, {"x", x}});
  json["series"] = Filling::array();
  for (const auto& series : plot.series) {
    Filling one{{"label", series.label},
                {"style", style_names[static_cast<std::size_t>(series.style)]},
                {"colour", series.colour},
                {"x", rounded(series.x)},
                {"y", rounded(series.y)}};
    if (!series.bar.empty()) one["bar"] = rounded(series.bar);
    json["series"].push_back(std::move(one));
  }
  return json;
}

}  // namespace fretval
