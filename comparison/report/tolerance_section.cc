#include "comparison/report/tolerance_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "comparison/report/plots.h"
#include "comparison/support/escape.h"

namespace fretval {
namespace {

using nlohmann::ordered_json;

// Errors below it are roundoff, or exact zeros, which a logarithmic axis does not show.
constexpr double smallest_shown = 1e-10;

std::string cell(const ordered_json& value) {
  return value.is_number() ? fmt::format("{:.3g}", value.get<double>()) : "–";
}

std::string row_of(const ordered_json& s) {
  std::string names;
  for (const auto& name : s.at("inconclusive"))
    names += (names.empty() ? "" : ", ") + html_escaped(name.get<std::string>());
  const bool all_met = s.at("meet") == s.at("cases"), all_covered = s.at("covered") == s.at("errors");
  const char* bad = " class=\"bad-cell\"";
  return fmt::format(
      "<tr><td>{:.0e}</td><td{}>{} of {}</td><td{}>{} of {}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td>"
      "<td>{} of {}</td><td>{}</td></tr>\n",
      s.at("tolerance").get<double>(), all_met ? "" : bad, s.at("meet").get<int>(), s.at("cases").get<int>(),
      all_covered ? "" : bad, s.at("covered").get<int>(), s.at("errors").get<int>(), cell(s.at("median_effectivity")),
      cell(s.at("high_effectivity")), cell(s.at("median_cost_ratio")), cell(s.at("largest_cost_ratio")),
      s.at("not_in_grid").get<int>(), s.at("searched").get<int>(), names.empty() ? "none" : names);
}

Plot error_bar_plot(const ordered_json& json) {
  Plot plot;
  plot.title = "Error bar over true error";
  plot.x_label = "true error";
  plot.y_label = "error bar";
  plot.log_x = plot.log_y = true;
  double largest = smallest_shown;
  int colour = 0;
  for (const auto& s : json.at("summary")) {
    Series series{
        fmt::format("tolerance {:.0e}", s.at("tolerance").get<double>()), {}, {}, Series::Style::points, colour++};
    for (const auto& record : json.at("records")) {
      if (record.at("tolerance") != s.at("tolerance")) continue;
      for (const auto* errors : {&record.at("errors"), &record.at("economised").at("errors")})
        for (const auto& [quantity, e] : errors->items()) {
          if (!e.at("error").is_number() || !e.at("bar").is_number()) continue;
          series.x.push_back(std::max(std::abs(e.at("error").get<double>()), smallest_shown));
          series.y.push_back(std::max(e.at("bar").get<double>(), smallest_shown));
          largest = std::max({largest, series.x.back(), series.y.back()});
        }
    }
    plot.series.push_back(std::move(series));
  }
  plot.series.push_back(
      {"limit of coverage", {smallest_shown, largest}, {smallest_shown, largest}, Series::Style::line, 7});
  return plot;
}

Plot cost_plot(const ordered_json& json) {
  Plot plot;
  plot.title = "Cost over that of the cheapest setting of the grid";
  plot.x_label = "case, by rising ratio";
  plot.y_label = "ratio of seconds";
  plot.log_y = true;
  int colour = 0;
  for (const auto& s : json.at("summary")) {
    Series series{
        fmt::format("tolerance {:.0e}", s.at("tolerance").get<double>()), {}, {}, Series::Style::points, colour++};
    for (const auto& record : json.at("records"))
      if (record.at("tolerance") == s.at("tolerance") && record.at("cheapest").is_object())
        series.y.push_back(record.at("cheapest").at("ratio").get<double>());
    std::sort(series.y.begin(), series.y.end());
    for (std::size_t i = 0; i < series.y.size(); ++i) series.x.push_back(static_cast<double>(i + 1));
    plot.series.push_back(std::move(series));
  }
  return plot;
}

bool has_points(const Plot& plot) {
  return std::any_of(plot.series.begin(), plot.series.end(), [](const Series& s) { return !s.x.empty(); });
}

}  // namespace

std::string tolerance_section(const ordered_json& json) {
  if (!json.contains("records") || json.at("records").empty()) return "";
  std::string html =
      "<h2>Is the tolerance met, and at what cost?</h2>\n<p>Varied cases whose exact answer MDR gives. Errors: of the "
      "answer that the error bars prove, and of the cheapest settings which that proof covers. Met: they are within "
      "the tolerance (a tenth of it for contact radius and force). Covered: the true error is within the error bar. "
      "Effectivity: error bar over true error. Cost ratio: seconds of the cheapest settings so proved over those of "
      "the "
      "cheapest setting of a grid that happens to meet the tolerance, all of them measured in one run. Case files: "
      "<code>fretval check --suite tolerance --write-cases FOLDER</code>; <code>fretval run</code> repeats any of "
      "them.</p>\n"
      "<div class=\"scroll\"><table><thead><tr><th>tolerance</th><th>met</th><th>covered</th><th>effectivity, "
      "median</th><th>90 % below</th><th>cost ratio, median</th><th>largest</th><th>not met by the grid</th>"
      "<th>inconclusive</th></tr></thead><tbody>\n";
  for (const auto& s : json.at("summary")) html += row_of(s);
  html += "</tbody></table></div>\n<div class=\"figures\">\n";
  html += fmt::format(
      "<figure>{}<figcaption>A point a quantity and case; below the line the error bar does not cover the "
      "error. Smaller values are drawn at 10<sup>-10</sup>.</figcaption></figure>\n",
      svg(error_bar_plot(json)));
  const auto costs = cost_plot(json);
  if (has_points(costs))
    html += fmt::format(
        "<figure>{}<figcaption>Without the cases that no setting of the grid meets.</figcaption></figure>\n",
        svg(costs));
  return html + "</div>\n";
}

}  // namespace fretval
