#include "comparison/report/drawing/plot_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "comparison/report/text/numbers.h"
#include "comparison/report/text/table.h"

namespace fretval {
namespace {

constexpr std::size_t most_rows = 40;

std::string number(const Filling& value) {
  return value == 0 ? "0" : number_text(value, "{:.5g}");  // without the sign of -0
}

/// The places of so many of n, the first and the last among them.
std::vector<std::size_t> thinned(std::size_t n, std::size_t n_kept) {
  std::vector<std::size_t> kept;
  if (n <= n_kept)
    for (std::size_t i = 0; i < n; ++i) kept.push_back(i);
  else
    for (std::size_t i = 0; i < n_kept; ++i) kept.push_back(i * (n - 1) / (n_kept - 1));
  return kept;
}

/// Places of a series that have both numbers.
std::vector<std::size_t> points_of(const Filling& series) {
  std::vector<std::size_t> points;
  for (std::size_t i = 0; i < series.at("x").size(); ++i)
    if (number(series["x"][i]) != "–" && number(series.at("y").at(i)) != "–") points.push_back(i);
  return points;
}

/// A row a point. A series without a name belongs to the one before.
Table table_of_series(const Filling& plot) {
  Table table{{"series", without_subscripts(plot.at("x_label")), without_subscripts(plot.at("y_label"))}};
  const auto& all = plot.at("series");
  const bool has_bars = std::any_of(all.begin(), all.end(), [](const Filling& s) { return s.contains("bar"); });
  if (has_bars) table.heads.emplace_back("error bar");
  const std::size_t n_kept = std::max<std::size_t>(3, most_rows / std::max<std::size_t>(1, all.size()));
  std::string name;
  for (const auto& series : all) {
    if (series.at("label") != "") name = without_subscripts(series["label"]);
    const auto points = points_of(series);
    for (const auto k : thinned(points.size(), n_kept)) {
      const auto i = points[k];
      table.rows.push_back({name, number(series["x"][i]), number(series["y"][i])});
      if (has_bars) table.rows.back().push_back(series.contains("bar") ? number(series["bar"].at(i)) : "–");
    }
  }
  return table;
}

const char* name_of_zone(char zone) {
  if (zone == 's') return "sticks";
  if (zone == 'f') return "slips forward";
  return zone == 'b' ? "slips backward" : "open";
}

/// At some instants, zones from the middle outwards.
Table table_of_zones(const Filling& map) {
  Table table{{map.at("x_label"), "zones up to " + map.at("y_label").get<std::string>()}};
  const auto zones = map.at("zones").get<std::vector<std::string>>();
  for (const auto k : thinned(zones.size(), most_rows)) {
    std::string text;
    for (std::size_t i = 0; i < zones[k].size(); ++i)
      if (i + 1 == zones[k].size() || zones[k][i + 1] != zones[k][i])
        text += fmt::format("{}{} to {}", text.empty() ? "" : ", ", name_of_zone(zones[k][i]),
                            number(map.at("edges").at(i)));
    table.rows.push_back(
        {fmt::format("{:.3g}", static_cast<double>(k) / static_cast<double>(zones.size())), words_cell(text)});
  }
  return table;
}

Table table_of_shares(const Filling& bars) {
  Table table{{""}};
  table.label = bars.at("x_label");
  for (const auto& source : bars.at("sources")) table.heads.push_back(source.get<std::string>());
  for (const auto& row : bars.at("rows")) {
    table.rows.push_back({row.at("label").get<std::string>()});
    for (const auto& share : row.at("shares")) table.rows.back().push_back(number(share));
  }
  return table;
}

Table table_of(const Filling& plot) {
  const auto kind = plot.value("kind", "");
  return kind == "map" ? table_of_zones(plot) : kind == "bars" ? table_of_shares(plot) : table_of_series(plot);
}

}  // namespace

std::string without_subscripts(const std::string& text) {
  std::string plain;
  bool in_braces = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '_' && i + 1 < text.size()) {
      in_braces = text[i + 1] == '{';
      i += in_braces ? 1 : 0;
    } else if (in_braces && text[i] == '}') {
      in_braces = false;
    } else {
      plain += text[i];
    }
  }
  return plain;
}

Filling plot_table(const Filling& plot) {
  Filling filling{{"template", "plot_table"}, {"title", without_subscripts(plot.at("title"))}};
  if (plot.contains("equal_scales")) {
    filling["instead"] = "a picture, which a script draws; its numbers are in the CSV files beside result.json.";
    return filling;
  }
  const auto table = table_of(plot);
  if (table.rows.empty())
    filling["instead"] = "no data.";
  else
    filling["table"] = filling_of(table);
  return filling;
}

}  // namespace fretval
