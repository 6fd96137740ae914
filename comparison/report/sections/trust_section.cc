#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "comparison/model_error/coordinates.h"
#include "comparison/model_error/level_lines.h"
#include "comparison/report/drawing/figures.h"
#include "comparison/report/drawing/plots.h"
#include "comparison/report/sections/sections.h"
#include "comparison/report/text/table.h"
#include "comparison/results/unit_text.h"

namespace fretval {
namespace {

using nlohmann::ordered_json;

constexpr double percent = 100;

/// What finite elements find over what MDR says, less 1, in percent: the change that a rung makes.
struct ChangeInPercent {
  double value, bar;
};

ChangeInPercent change_of(const ordered_json& off_by) {
  const double value = off_by.at("value").get<double>(), bar = off_by.at("uncertainty").get<double>();
  return {percent * (1 / (1 + value) - 1), percent * bar / ((1 + value) * (1 + value))};
}

std::string changed(const ordered_json& all, const char* key) {
  const auto found = all.find(key);
  if (found == all.end()) return "–";
  const auto [value, bar] = change_of(*found);
  if (std::abs(value) <= bar) return fmt::format("within {:.2g} %", bar);
  const int decimals = bar > 0 ? std::clamp(static_cast<int>(std::ceil(-std::log10(bar))), 0, 6) : 3;
  return fmt::format("{:+.{}f} ± {:.{}f} %", value, decimals, bar, decimals);
}

/// Each assumption that is dropped, what they do together beyond that, and the whole, from MDR's value on.
Filling waterfall_of(const ordered_json& trust, const std::string& key) {
  std::vector<ShareRow> rows;
  double sum = 0, bars = 0;
  const auto add = [&](const std::string& label, double start, double change, double bar) {
    rows.push_back({label, {std::max(change, 0.0), std::min(change, 0.0)}, start, bar});
  };
  for (const auto& [name, rung] : trust.at("rungs").items()) {
    const auto found = rung.at("mdr_off_by").find(key);
    if (found == rung.at("mdr_off_by").end()) continue;
    const auto [value, bar] = change_of(*found);
    add(rung.at("title").get<std::string>(), sum, value, bar);
    sum += value;
    bars += bar;
  }
  const auto [whole, bar] = change_of(trust.at("mdr_off_by").at(key));
  if (rows.size() > 1) add("beyond the sum of these", sum, whole - sum, bars + bar);
  add("the case as it is", 0, whole, bar);
  auto plot = share_bars(traits_of(*quantity_of(key)).title + std::string(": what MDR leaves out"),
                         "change against MDR's value in %", {"larger than MDR has it", "smaller"}, rows, 0, "%");
  return {{"plot", std::move(plot)},
          {"caption", "From MDR's own model on, an assumption a bar; black: error bars of the finite elements."},
          {"wide", true}};
}

Table ladder_table(const ordered_json& trust) {
  Table table{{"quantity", "MDR", "finite elements", "change"}};
  table.label = "the ladder of assumptions";
  const bool many = trust.at("rungs").size() > 1;
  if (many)
    for (const auto& [name, rung] : trust.at("rungs").items())
      table.heads.push_back(rung.at("title").get<std::string>());
  for (const auto quantity : quantities_by_interest) {
    const auto& traits = traits_of(quantity);
    if (!trust.at("fe").contains(traits.name)) continue;
    const auto& fe = trust.at("fe").at(traits.name);
    table.rows.push_back({traits.title, with_unit(trust.at("mdr").at(traits.name).get<double>(), 0, traits.unit),
                          with_unit(fe.at("value").get<double>(), fe.at("uncertainty").get<double>(), traits.unit),
                          changed(trust.at("mdr_off_by"), traits.name)});
    if (many)
      for (const auto& [name, rung] : trust.at("rungs").items())
        table.rows.back().push_back(changed(rung.at("mdr_off_by"), traits.name));
  }
  return table;
}

/// The zones of the case as it is, beside MDR's discs.
Figure zones_figure(const ordered_json& trust) {
  const auto& zones = trust.at("zones");
  const auto edge = [&](const char* name) { return zones.value(name, std::vector<double>()); };
  const auto radius = [&](Quantity quantity) -> std::optional<double> {
    const auto found = trust.at("mdr").find(name_of(quantity));
    return found == trust.at("mdr").end() ? std::nullopt : std::optional(found->get<double>());
  };
  return edges_figure({edge("angle"), edge("contact"), edge("never_slipped"), edge("sticks_in_a_cycle")},
                      {radius(Quantity::contact_radius_max), radius(Quantity::stick_radius_first_slip),
                       radius(Quantity::stick_radius_shakedown)});
}

struct MapOfPage {
  MapKind kind;
  const char *title, *y_label, *coordinate;
};
constexpr std::array maps_of_page{
    MapOfPage{MapKind::phase, "Friction as a vector", "phase in degrees", "phase"},
    MapOfPage{MapKind::poisson_ratio, "Half-space, coupled", "Poisson's ratio", "poisson_ratio"},
    MapOfPage{MapKind::layer, "Bonded layer, coupled", "a/H by MDR", "radius_over_thickness"}};

/// Lines of equal errors, and the case.
Figure error_map_figure(const MapOfPage& map, const ordered_json& at, Quantity quantity) {
  Plot plot{fmt::format("{}: {}", map.title, traits_of(quantity).title), "c/a by MDR", map.y_label};
  plot.x_range = {least_mapped_ratio, most_mapped_ratio};
  const std::vector<double> levels{0.01, 0.02, 0.05, 0.1, 0.2};
  const auto [lines, hatching] = map_lines(map_points(), map.kind, quantity, levels);
  for (std::size_t k = 0; k < levels.size(); ++k)
    if (!lines[k].x.empty())
      plot.series.push_back({fmt::format("{:g} %", percent * levels[k]), lines[k].x, lines[k].y, Series::Style::line,
                             static_cast<int>(k)});
  if (!hatching.x.empty())
    plot.series.push_back({"hatched: bars above a tenth", hatching.x, hatching.y, Series::Style::thin_line, 7});
  const auto ratio = at.find(name_of(quantity));
  const auto& value = at.at(map.coordinate);
  if (ratio != at.end() && value.is_number()) {
    const double number = value.get<double>(), y = map.kind == MapKind::phase ? phase_on_maps(number) : number;
    plot.series.push_back({"this case", {ratio->get<double>()}, {y}, Series::Style::triangles, 7});
  }
  return {
      plot,
      fmt::format(
          "Where MDR over an incompressible half-space is off by so much in the {}; parabola, elastic, "
          "μ = 0.5, k = 0.5. Hatched: near points whose error bar is more than a tenth of what they show, and 0.1 %.",
          traits_of(quantity).title)};
}

}  // namespace

Filling trust_section(const ordered_json& trust) {
  Filling filling{{"template", "trust"},
                  {"name", trust.at("name")},
                  {"headline", trust.at("headline")},
                  {"table", filling_of(ladder_table(trust))},
                  {"scene", {{"template", "scene"}, {"inputs", inputs_of(trust)}}},
                  {"not_computed", Filling::array()}};
  for (const auto& one : trust.at("not_computed"))
    filling["not_computed"].push_back({{"assumption", one.at("assumption")}, {"order", one.at("order")}});
  if (!trust.contains("headline_quantity")) return filling;
  const auto key = trust.at("headline_quantity").get<std::string>();
  const auto quantity = quantity_of(key);
  filling["waterfall"] = {{"template", "figures"}, {"figures", Filling::array()}};
  filling["waterfall"]["figures"].push_back(waterfall_of(trust, key));
  if (trust.contains("zones")) filling["zones"] = filling_of({zones_figure(trust)});
  std::vector<Figure> maps;
  for (const auto& map : maps_of_page) maps.push_back(error_map_figure(map, trust.at("at"), *quantity));
  filling["maps"] = filling_of(maps);
  return filling;
}

}  // namespace fretval
