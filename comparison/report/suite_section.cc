#include "comparison/report/suite_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "comparison/report/figures.h"
#include "comparison/support/escape.h"

namespace fretval {
namespace {

using nlohmann::ordered_json;

// Errors below it are roundoff, or exact zeros, which a logarithmic axis does not show.
constexpr double smallest_shown = 1e-10;

std::string text(const ordered_json& value) {
  return value.is_string() ? html_escaped(value.get<std::string>()) : "";
}

std::string number(const ordered_json& value, const char* format = "{:.1e}") {
  return value.is_number() ? fmt::format(fmt::runtime(format), value.get<double>()) : "–";
}

std::string verdict_html(const ordered_json& json) {
  const auto& s = json.at("summary");
  const bool pass = s.at("pass").get<bool>();
  std::string html = fmt::format(
      "<h2>Suite {0}</h2>\n<p><span class=\"badge {1}\">{2}</span> {3} {4} cases: {5} agree, {6} are refused by name "
      "as "
      "they have to be, {7} are inconclusive (right within an error bar that is wider than the tolerance), {8} fail. "
      "{9} of {10} errors are above their bars. To repeat: <code>fretval check --suite {0}</code>, {11} computations, "
      "{12:.0f} s.",
      text(json.at("suite")), pass ? "good" : "bad", pass ? "pass" : "fail", text(json.at("about")),
      s.at("cases").get<int>(), s.at("agree").get<int>(), s.at("refused").get<int>(), s.at("inconclusive").get<int>(),
      s.at("fail").get<int>(), s.at("above_bar").get<int>(), s.at("errors").get<int>(),
      s.at("computations").get<long>(), s.at("seconds").get<double>());
  for (const auto& check : json.at("checks"))
    html += fmt::format(" {}: {}{}.", text(check.at("name")), text(check.at("finding")),
                        check.at("failure").is_string() ? ": <b>" + text(check.at("failure")) + "</b>" : "");
  return html + "</p>\n";
}

std::string quantity_row(const ordered_json& q) {
  const auto n_above = q.at("above_bar").get<int>();
  const auto &error = q.at("error"), &bar = q.at("bar"), &effectivity = q.at("effectivity");
  return fmt::format(
      "<tr><td>{}</td><td>{}</td><td>{}</td><td{}>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td>"
      "<td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
      text(q.at("quantity")), number(q.at("tolerance")), q.at("errors").get<int>(),
      n_above == 0 ? "" : " class=\"bad-cell\"", n_above, q.at("wide").get<int>(), q.at("unbounded").get<int>(),
      number(error.at("median")), number(error.at("high")), number(bar.at("median")), number(bar.at("high")),
      number(effectivity.at("low"), "{:.3g}"), number(effectivity.at("median"), "{:.3g}"),
      number(effectivity.at("high"), "{:.3g}"));
}

std::string quantities_html(const ordered_json& quantities) {
  std::string html =
      "<div class=\"scroll\"><table><thead><tr><th>quantity</th><th>tolerance</th><th>errors</th><th>above bar</th>"
      "<th>bars above tolerance</th><th>unbounded</th><th>error, median</th><th>90 % below</th><th>bar, median</th>"
      "<th>90 % below</th><th>bar over error, 10 % below</th><th>median</th><th>90 % below</th></tr></thead><tbody>\n";
  for (const auto& q : quantities) html += quantity_row(q);
  return html + "</tbody></table></div>\n";
}

/// A series a tolerance of a quantity.
Plot error_bar_plot(const ordered_json& rows) {
  std::map<double, Series> by_tolerance;
  double largest = smallest_shown;
  for (const auto& row : rows)
    for (const auto& [quantity, q] : row.at("quantities").items()) {
      if (!q.at("error").is_number() || !q.at("bar").is_number()) continue;
      auto& series = by_tolerance[q.at("tolerance").get<double>()];
      series.x.push_back(std::max(std::abs(q.at("error").get<double>()), smallest_shown));
      series.y.push_back(std::max(q.at("bar").get<double>(), smallest_shown));
      largest = std::max({largest, series.x.back(), series.y.back()});
    }
  Plot plot;
  plot.title = "Error bar over true error";
  plot.x_label = "true error";
  plot.y_label = "error bar";
  plot.log_x = plot.log_y = true;
  int colour = 0;
  for (auto& [tolerance, series] : by_tolerance) {
    series.label = fmt::format("tolerance {:.2g}", tolerance);
    series.style = Series::Style::points;
    series.colour = colour++;
    plot.series.push_back(std::move(series));
  }
  if (!plot.series.empty())
    plot.series.push_back(
        {"limit of coverage", {smallest_shown, largest}, {smallest_shown, largest}, Series::Style::line, 7});
  return plot;
}

std::string figure_html(const ordered_json& json) {
  const auto& rows = json.at("rows");
  if (rows.size() != json.at("summary").at("cases").get<std::size_t>()) return "";
  auto plot = error_bar_plot(rows);
  if (plot.series.empty()) return "";
  return figures_html({{std::move(plot),
                        "A point a quantity and case; below the line the error bar does not cover the error. Smaller "
                        "values are drawn at 10<sup>-10</sup>."}});
}

std::string row_html(const ordered_json& row) {
  std::string numbers = "<td>–</td><td>–</td><td>–</td><td>–</td><td>–</td><td>–</td>";
  if (row.at("worst").is_string()) {
    const auto& q = row.at("quantities").at(row.at("worst").get<std::string>());
    numbers = fmt::format("<td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td>", text(row.at("worst")),
                          number(q.at("mdr"), "{:.6f}"), number(q.at("fe"), "{:.6f}"), number(q.at("error")),
                          number(q.at("bar")), number(q.at("tolerance")));
  }
  const auto& family = row.at("family");
  return fmt::format(
      "<tr><td>{}{}{}</td><td{}>{}</td>{}<td>{}</td><td class=\"words\">{}</td><td class=\"words\"><details><summary>"
      "case file</summary><pre>{}</pre></details></td></tr>\n",
      text(family), family.get<std::string>().empty() ? "" : ": ", text(row.at("name")),
      row.at("verdict") == "FAIL" ? " class=\"bad-cell\"" : "", text(row.at("verdict")), numbers,
      number(row.at("seconds"), "{:.2f}"), text(row.at("remark")), text(row.at("case_file")));
}

std::string rows_html(const ordered_json& rows) {
  std::string html = fmt::format(
      "<details><summary>{} cases, each with the quantity that is closest to its bar</summary>\n<div class=\"scroll\">"
      "<table><thead><tr><th>case</th><th>verdict</th><th>quantity</th><th>MDR</th><th>FE</th><th>error</th><th>bar</"
      "th>"
      "<th>tolerance</th><th>seconds</th><th>remark</th><th></th></tr></thead><tbody>\n",
      rows.size());
  for (const auto& row : rows) html += row_html(row);
  return html + "</tbody></table></div></details>\n";
}

}  // namespace

std::string suite_section(const ordered_json& json) {
  return verdict_html(json) + quantities_html(json.at("quantities")) + figure_html(json) + rows_html(json.at("rows"));
}

}  // namespace fretval
