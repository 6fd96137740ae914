#include <fmt/format.h>

#include <map>
#include <string>
#include <utility>

#include "comparison/report/drawing/figures.h"
#include "comparison/report/drawing/plots.h"
#include "comparison/report/sections/sections.h"
#include "comparison/report/text/numbers.h"
#include "comparison/report/text/table.h"
#include "comparison/results/unit_text.h"
#include "comparison/support/constants.h"
#include "comparison/support/json.h"

namespace fretval {
namespace {

using nlohmann::ordered_json;
using Numbers = std::vector<double>;

const ordered_json* surface_wear_of(const StoredResult& r) {
  const auto& fe = r.json.at("fe");
  const auto found = fe.find("surface_wear");
  return found == fe.end() ? nullptr : &*found;
}

std::string with_bar(const ordered_json& zone, const std::string& key) {
  return with_unit(zone.at(key).get<double>(), number_in(zone, key + "_bar").value_or(0), "m");
}

/// The radius that sticks and the worn volume in the course of the wear, over those of MDR's limit.
Figure course_figure(const ordered_json& wear) {
  Plot plot{"In the course of wear", "cycles", "over that of MDR's limit"};
  plot.log_x = true;
  const auto add = [&](const char* key, const char* label, int colour) {
    const double unit = wear.at("limit_of_mdr").at(key).get<double>();
    plot.series.push_back(over_cycles(wear, key, unit, {label, {}, {}, Series::Style::line_points, colour}));
  };
  add("stick_radius", "radius of what sticks", 2);
  add("volume", "worn volume", 1);
  return {std::move(plot), "Points: the jumps of the finite elements over many cycles. MDR's limit is at 1."};
}

/// Heights over the radius in four directions, beside the unworn indenter and MDR's limiting profile.
Figure directions_figure(const StoredResult& r) {
  const auto file = r.folder / "worn_surface.csv";
  const auto column = [&](const char* name) { return read_columns(file, "angle [rad]", name); };
  const auto [angle, inner] = column("r inner [m]");
  const auto outer = column("r outer [m]").second, worn = column("f worn [m]").second;
  const double length = r.number("scene", "contact_radius_unworn"), depth = r.number("scene", "indentation_max");
  const Numbers lengths{length}, depths{depth};
  const auto radius = axis_for({&lengths}, "m"), height = axis_for({&depths}, "m");
  Plot plot{"Worn profile", "r in " + radius.unit, "f in " + height.unit};
  plot.series.push_back(curve_from(r, "profile.csv", "f unworn [m]", radius.factor, height.factor,
                                   {"unworn", {}, {}, Series::Style::line, 0}));
  std::map<double, Series> directions;  // by angle
  for (std::size_t i = 0; i < angle.size(); ++i) directions[angle[i]];
  const std::size_t stride = std::max<std::size_t>(1, directions.size() / 4);
  std::size_t number = 0;
  int colour = 1;
  for (auto& [theta, series] : directions) {
    if (number++ % stride != 0) continue;
    series = {fmt::format("at {:.0f} degrees", theta * 180 / pi), {}, {}, Series::Style::line, colour++};
    for (std::size_t i = 0; i < angle.size(); ++i) {
      if (angle[i] != theta) continue;
      series.x.push_back((inner[i] + outer[i]) / 2 / radius.factor);
      series.y.push_back(worn[i] / height.factor);
    }
    plot.series.push_back(std::move(series));
  }
  plot.series.push_back(curve_from(r, "profile.csv", "f limiting [m]", radius.factor, height.factor,
                                   {"limit, MDR", {}, {}, Series::Style::dashed, 7}));
  plot.x_range = {0, 1.5 * length / radius.factor};
  plot.y_range = {0, 1.2 * depth / height.factor};
  return {std::move(plot), "The indenter at the end of its wear in several directions from the axis, against x."};
}

}  // namespace

Filling surface_wear_section(const std::vector<StoredResult>& results) {
  Table table{{"case", "worn volume", "MDR's limit", "what sticks: radius", "MDR's limit", "along x", "across"}, {}};
  std::vector<Figure> figures;
  for (const auto& r : results) {
    const auto* wear = surface_wear_of(r);
    if (!wear) continue;
    const auto &sticks = wear->at("sticks"), &limit = wear->at("limit_of_mdr");
    const auto bar = number_in(*wear, "volume_bar");
    const auto volume = wear->at("volume").back().get<double>();
    table.rows.push_back({r.name(), volume_text(volume) + (bar ? fmt::format(" ± {:.2g} %", 100 * *bar / volume) : ""),
                          volume_text(limit.at("volume").get<double>()), with_bar(sticks, "radius"),
                          with_unit(limit.at("stick_radius").get<double>(), 0, "m"), with_bar(sticks, "along"),
                          with_bar(sticks, "across")});
    figures.push_back(course_figure(*wear));
    figures.push_back(directions_figure(r));
  }
  if (table.rows.empty()) return nullptr;
  return {{"template", "surface_wear"}, {"table", filling_of(table)}, {"shapes", filling_of(figures)}};
}

}  // namespace fretval
