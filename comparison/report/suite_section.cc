#include "comparison/report/suite_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "comparison/report/figures.h"
#include "comparison/report/table.h"
#include "comparison/support/escape.h"

namespace fretval {
namespace {

using nlohmann::ordered_json;

// Errors below it are roundoff, or exact zeros, which a logarithmic axis does not show.
constexpr double smallest_shown = 1e-10;

std::string text(const ordered_json& value) {
  return value.is_string() ? html_escaped(value.get<std::string>()) : "";
}

/// "4 cases: 1 agree, ..."
std::string summary_text(const ordered_json& summary) {
  const auto n = [&](const char* key) { return summary.at(key).get<long>(); };
  return fmt::format(
      "{} cases: {} agree, {} are refused by name as they have to be, {} are inconclusive (right within an error bar "
      "that is wider than the tolerance), {} fail. {} of {} errors are above their bars. {} computations, {:.0f} s.",
      n("cases"), n("agree"), n("refused"), n("inconclusive"), n("fail"), n("above_bar"), n("errors"),
      n("computations"), summary.at("seconds").get<double>());
}

std::string verdict_html(const ordered_json& json) {
  const bool pass = json.at("summary").at("pass").get<bool>();
  return fmt::format(
      "<h2>Suite {0}</h2>\n<p><span class=\"badge {1}\">{2}</span> {3} {4} To repeat: <code>fretval check --suite "
      "{0}</code>.</p>\n",
      text(json.at("suite")), pass ? "good" : "bad", pass ? "pass" : "fail", text(json.at("about")),
      summary_text(json.at("summary")));
}

Table quantities_table(const ordered_json& quantities) {
  Table table{{"quantity", "tolerance", "errors", "above bar", "bars above tolerance", "error, median", "90 % below",
               "bar, median", "90 % below", "bar over error, median", "90 % below"}};
  for (const auto& q : quantities) {
    std::vector<Cell> row{q.at("quantity").get<std::string>(), number_text(q.at("tolerance"))};
    for (const char* key : {"errors", "above_bar", "wide"})
      row.push_back(bad_if(std::string(key) == "above_bar" && q.at(key) != 0, number_text(q.at(key), "{:.0f}")));
    for (const char* key : {"error", "bar", "effectivity"})
      for (const char* share : {"median", "high"})
        row.emplace_back(number_text(q.at(key).at(share), std::string(key) == "effectivity" ? "{:.3g}" : "{:.1e}"));
    table.rows.push_back(std::move(row));
  }
  return table;
}

/// Each case with the quantity that is closest to its bar.
Table cases_table(const ordered_json& rows) {
  Table table{{"case", "verdict", "quantity", "MDR", "FE", "error", "bar", "tolerance", "seconds", "remark"}};
  for (const auto& row : rows) {
    const bool has_worst = row.at("worst").is_string();
    const auto worst = has_worst ? row["worst"].get<std::string>() : "–";
    const auto number = [&](const char* key, const char* format = "{:.1e}") {
      return has_worst ? number_text(row.at("quantities").at(worst).at(key), format) : "–";
    };
    const auto family = row.at("family").get<std::string>(), verdict = row.at("verdict").get<std::string>();
    Cell name((family.empty() ? "" : family + ": ") + row.at("name").get<std::string>());
    name.details = row.at("case_file").get<std::string>();
    const auto& remark = row.at("remark");
    table.rows.push_back({name, bad_if(verdict == "FAIL", verdict), worst, number("mdr", "{:.6f}"),
                          number("fe", "{:.6f}"), number("error"), number("bar"), number("tolerance"),
                          number_text(row.at("seconds"), "{:.2f}"),
                          words_cell(remark.is_string() ? remark.get<std::string>() : "")});
  }
  return table;
}

bool has_all_rows(const ordered_json& json) {
  return json.at("rows").size() == json.at("summary").at("cases").get<std::size_t>();
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
  Plot plot{"Error bar over true error", "true error", "error bar"};
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
  if (!has_all_rows(json)) return "";
  auto plot = error_bar_plot(json.at("rows"));
  if (plot.series.empty()) return "";
  return figures_html({{std::move(plot),
                        "A point a quantity and case; below the line the error bar does not cover the error. Smaller "
                        "values are drawn at 10<sup>-10</sup>."}});
}

}  // namespace

std::string suite_section(const ordered_json& json) {
  const auto& rows = json.at("rows");
  return verdict_html(json) + html_of(quantities_table(json.at("quantities"))) + figure_html(json) +
         fmt::format(
             "<details><summary>{} cases, each with the quantity that is closest to its bar</summary>\n{}"
             "</details>\n",
             rows.size(), html_of(cases_table(rows)));
}

std::string suite_text(const ordered_json& json) {
  const auto& summary = json.at("summary");
  return fmt::format("{}{}\n{}\n{}: {}\n",
                     has_all_rows(json) ? "" : fmt::format("the worst of {}\n", summary.at("cases").get<std::size_t>()),
                     text_of(cases_table(json.at("rows"))), text_of(quantities_table(json.at("quantities"))),
                     summary.at("pass").get<bool>() ? "pass" : "FAIL", summary_text(summary));
}

}  // namespace fretval
