#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <vector>

#include "comparison/quantities/quantity.h"
#include "comparison/report/drawing/figures.h"
#include "comparison/report/sections/sections.h"
#include "comparison/report/text/numbers.h"
#include "comparison/report/text/table.h"
#include "comparison/results/results_folder.h"

namespace fretval {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::vector<fs::path> trades_below(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().filename() == "trade.json") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

const Json& level_at(const Json& trade, const Json& index) {
  return trade.at("levels").at(index.get<std::size_t>());
}

std::string kind_of(const Json& level) {
  return level.at("kind").get<std::string>();
}

std::vector<Cell> row_of(const std::string& name, const Json& level, bool is_bad = false) {
  std::vector<Cell> row{name};
  for (const char* key : {"elements_per_radius", "degree", "growth", "far_radius", "steps_per_cycle"})
    row.emplace_back(number_text(level.at("setting").value(key, Json()), "{:g}"));
  row.push_back(bad_if(is_bad, number_text(level.at("error"))));
  row.emplace_back(number_text(level.at("seconds"), "{:.3g}"));
  return row;
}

/// The recommended settings beside the tool's own, the front, and the other levels.
Table settings_table(const Json& trade) {
  Table table{{"", "rings", "order", "grading", "far radius", "steps", "error", "seconds"}};
  for (const auto& r : trade.at("recommendations")) {
    const auto tolerance = number_text(r.at("tolerance"), "{:.0e}");
    table.rows.push_back(r.at("cheapest").is_number()
                             ? row_of("cheapest for " + tolerance, level_at(trade, r["cheapest"]))
                             : std::vector<Cell>{"no setting of the plan meets " + tolerance});
    const bool meets = r.at("chosen_meets_tolerance").get<bool>();
    table.rows.push_back(row_of(fmt::format("chosen by the tool for {}{}", tolerance, meets ? "" : ", too coarse"),
                                level_at(trade, r.at("chosen")), !meets));
  }
  for (const auto& index : trade.at("front")) table.rows.push_back(row_of("front", level_at(trade, index)));
  for (const auto& level : trade.at("levels")) {
    const auto kind = kind_of(level), number = number_text(level.at("setting").value("springs", Json()), "{:.0f} ");
    if (kind != "condensed") table.rows.push_back(row_of(kind == "springs" ? number + kind : kind, level));
  }
  return table;
}

std::string list_text(const Json& numbers, const char* format) {
  std::string text;
  for (const auto& number : numbers) text += (text.empty() ? "" : ", ") + number_text(number, format);
  return text;
}

Table axes_table(const Json& trade) {
  Table table{{"alone", "values", "errors", "error goes with the power"}};
  for (const auto& [axis, found] : trade.at("axes").items())
    table.rows.push_back({axis, list_text(found.at("values"), "{:g}"), list_text(found.at("errors"), "{:.1e}"),
                          number_text(found.at("power"), "{:.1f}")});
  return table;
}

Plot error_plot(const std::string& x_label, const std::string& title) {
  Plot plot{title, x_label, "error"};
  plot.log_x = plot.log_y = true;
  return plot;
}

void add(Series& series, const Json& x, const Json& y) {
  if (!x.is_number() || !y.is_number()) return;
  series.x.push_back(x.get<double>());
  series.y.push_back(y.get<double>());
}

/// A cloud of points for each kind of level and order of elements, the front, and the closed form, whose error is none.
Figure cost_figure(const Json& trade) {
  std::map<std::string, Series> clouds;
  Series closed_form{"closed form: error 0", {}, {}, Series::Style::dashed, 5},
      front{"", {}, {}, Series::Style::line, 7};
  for (const auto& level : trade.at("levels")) {
    const auto kind = kind_of(level);
    const bool condensed = kind == "condensed";
    const auto order = condensed ? level.at("setting").at("degree").get<int>() : 0;
    auto& cloud = clouds[condensed ? fmt::format("order {}", order) : kind];
    cloud.style = condensed ? Series::Style::points : Series::Style::triangles;
    cloud.colour = condensed ? order - 2 : kind == "springs" ? 6 : 3;
    add(kind == "closed form" ? closed_form : cloud, level.at("seconds"), level.at("error"));
  }
  for (const auto& index : trade.at("front"))
    add(front, level_at(trade, index).at("seconds"), level_at(trade, index).at("error"));
  auto plot = error_plot("seconds", "Error over time");
  for (auto& [label, cloud] : clouds) {
    cloud.label = label;
    if (!cloud.x.empty()) plot.series.push_back(std::move(cloud));
  }
  if (!closed_form.x.empty() && !front.y.empty()) {
    closed_form.x.push_back(closed_form.x.front());
    closed_form.y = {front.y.front(), front.y.back()};
    plot.series.push_back(std::move(closed_form));
  }
  plot.series.push_back(std::move(front));
  return {std::move(plot),
          "Largest error over all compared quantities against the closed form of MDR, over the seconds "
          "of a setting (body and its own histories). Line: the front, no setting of which is beaten in both."};
}

Figure axis_figure(const Json& trade, const std::string& axis, const Json& found) {
  auto plot = error_plot(axis, "Error over " + axis);
  for (std::size_t k = 0; k < quantities_by_interest.size(); ++k) {
    const auto& traits = traits_of(quantities_by_interest[k]);
    Series series{traits.label, {}, {}, Series::Style::line_points, static_cast<int>(k)};
    for (const auto& index : found.at("levels")) {
      const auto& level = level_at(trade, index);
      add(series, level.at("axes").at(axis), level.at("errors").value(traits.name, Json()));
    }
    if (!series.x.empty()) plot.series.push_back(std::move(series));
  }
  plot.x_tics = found.at("values").get<std::vector<double>>();
  const auto [least, largest] = std::minmax_element(plot.x_tics.begin(), plot.x_tics.end());
  plot.x_range = {*least / 1.15, *largest * 1.15};
  return {std::move(plot), "One axis alone, the others at the reference setting."};
}

std::vector<Figure> figures_of(const Json& trade) {
  std::vector<Figure> figures{cost_figure(trade)};
  for (const auto& [axis, found] : trade.at("axes").items())
    if (found.at("levels").size() > 1) figures.push_back(axis_figure(trade, axis, found));
  return figures;
}

Filling one_trade(const Json& trade) {
  return {{"name", trade.at("name").get<std::string>()},
          {"ways", counted(trade.at("levels").size(), "way")},
          {"settings", filling_of(settings_table(trade))},
          {"figures", filling_of(figures_of(trade))},
          {"axes", filling_of(axes_table(trade))}};
}

}  // namespace

std::string trade_text(const Json& trade) {
  return text_of(settings_table(trade)) + "\n" + text_of(axes_table(trade));
}

Filling trade_section(const fs::path& folder) {
  auto trades = Filling::array();
  for (const auto& file : trades_below(folder)) trades.push_back(section_of(file, one_trade));
  if (trades.empty()) return nullptr;
  return {{"template", "trade"}, {"trades", std::move(trades)}};
}

}  // namespace fretval
