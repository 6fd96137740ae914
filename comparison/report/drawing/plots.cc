#include "comparison/report/drawing/plots.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "comparison/results/answer_text.h"
#include "comparison/support/statistics.h"

namespace fretval {
namespace {

/// In the order of the enumeration.
constexpr std::array style_names{"line",   "dashed",       "thin line",   "line points",
                                 "points", "small points", "open points", "triangles"};

std::vector<double> rounded(std::vector<double> values) {
  for (double& value : values) value = to_digits(value, 6);
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

Filling share_bars(const std::string& title, const std::string& label, const std::vector<std::string>& sources,
                   const std::vector<ShareRow>& rows, double limit, const std::string& of_what) {
  Filling bars{{"kind", "bars"},     {"title", title}, {"x_label", label},        {"sources", sources},
               {"of_what", of_what}, {"limit", limit}, {"rows", Filling::array()}};
  for (const auto& [name, shares, start, bar] : rows)
    bars["rows"].push_back({{"label", name}, {"shares", shares}, {"start", start}, {"bar", bar}});
  return bars;
}

std::vector<double> outer_edges(const std::vector<double>& radii, double unit) {
  std::vector<double> edges;
  double square = 0;
  for (const double r : radii) edges.push_back(std::sqrt(square = 2 * r * r / (unit * unit) - square));
  return edges;
}

Filling zone_map(const std::string& title, const std::string& label, const std::vector<double>& edges,
                 const std::vector<std::string>& zones) {
  return {{"kind", "map"},    {"title", title}, {"x_label", "time over the period"},
          {"y_label", label}, {"edges", edges}, {"zones", zones}};
}

std::vector<double> Axis::of(std::vector<double> values) const {
  for (double& value : values) value /= factor;
  return values;
}

Axis axis_for(std::initializer_list<const std::vector<double>*> all, const std::string& unit) {
  double largest = 0;
  for (const auto* values : all)
    for (const double value : *values)
      if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  const auto [prefix, factor] = prefix_for(largest > 0 ? largest : 1);
  return {prefix + unit, factor};
}

std::vector<std::pair<std::string, double>> radius_marks(const StoredResult& result, const Axis& axis) {
  std::vector<std::pair<std::string, double>> marks;
  const double c = result.number("fe", "stick_radius_shakedown"), a = result.number("scene", "contact_radius_unworn");
  if (c > 0) marks.emplace_back("c", c / axis.factor);
  if (a > 0) marks.emplace_back("a", a / axis.factor);
  return marks;
}

}  // namespace fretval
