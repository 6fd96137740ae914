#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "comparison/quantities/quantity.h"
#include "comparison/report/drawing/figures.h"
#include "comparison/report/sections/sections.h"
#include "comparison/report/text/numbers.h"
#include "comparison/report/text/table.h"

namespace fretval {
namespace {

using nlohmann::ordered_json;

// Errors below it are roundoff, or exact zeros, which a logarithmic axis does not show.
constexpr double smallest_shown = 1e-10;

/// Title of a quantity by its name in the JSON.
std::string title_of_quantity(const std::string& name) {
  const auto quantity = quantity_of(name);
  return quantity ? traits_of(*quantity).title : name;
}

/// "4 cases: 1 agree, ..."
std::string summary_text(const ordered_json& summary) {
  const auto n = [&](const char* key) { return summary.at(key).get<long>(); };
  return fmt::format(
      "{}: {} agree, {} are refused by name as they have to be, {} are inconclusive (right within an error bar "
      "that is wider than the tolerance), {} fail. {} of {} errors are above their bars. {} computations, {:.0f} s.",
      counted(summary.at("cases").get<std::size_t>(), "case"), n("agree"), n("refused"), n("inconclusive"), n("fail"),
      n("above_bar"), n("errors"), n("computations"), summary.at("seconds").get<double>());
}

Table quantities_table(const ordered_json& quantities) {
  Table table{{"quantity", "tolerance", "errors", "above bar", "bars above tolerance", "error, median", "90 % below",
               "bar, median", "90 % below", "bar over error, median", "90 % below"}};
  for (const auto& q : quantities) {
    std::vector<Cell> row{title_of_quantity(q.at("quantity").get<std::string>()), number_text(q.at("tolerance"))};
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
    table.rows.push_back({name, bad_if(verdict == "FAIL", verdict), title_of_quantity(worst), number("mdr", "{:.6f}"),
                          number("fe", "{:.6f}"), number("error"), number("bar"), number("tolerance"),
                          number_text(row.at("seconds"), "{:.2f}"),
                          words_cell(remark.is_string() ? remark.get<std::string>() : "")});
  }
  return table;
}

bool has_all_rows(const ordered_json& json) {
  return json.at("rows").size() == json.at("summary").at("cases").get<std::size_t>();
}

/// A series for each tolerance of a quantity.
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

std::vector<Figure> suite_figures(const ordered_json& json) {
  if (!has_all_rows(json)) return {};
  auto plot = error_bar_plot(json.at("rows"));
  if (plot.series.empty()) return {};
  return {{std::move(plot),
           "A point a quantity and case; below the line the error bar does not cover the error. Smaller values are "
           "drawn at 1e-10."}};
}

std::string errors_text(const ordered_json& errors) {
  std::string text;
  for (const auto& error : errors)
    text += (text.empty() ? "" : ", ") + (error.is_number() ? number_text(error) : "not finite");
  return text;
}

Table convergence_table(const ordered_json& rows) {
  Table table{{"solution: quantity", "refined", "errors", "order (expected)", "tolerance", "verdict", "source; note"}};
  for (const auto& row : rows) {
    const auto text = [&](const char* key) { return row.at(key).get<std::string>(); };
    const auto &order = row.at("observed_order"), &resolutions = row.at("resolutions");
    table.rows.push_back(
        {text("solution") + ": " + text("quantity"),
         fmt::format("{} to {} {}", resolutions.front().get<int>(), resolutions.back().get<int>(), text("refined")),
         errors_text(row.at("errors")),
         fmt::format("{} ({:.2g})", order.is_number() ? number_text(order, "{:.1f}") : "floor",
                     row.at("expected_order").get<double>()),
         number_text(row.at("tolerance")), bad_if(text("verdict") != "pass", text("verdict")),
         words_cell(text("source") + (text("note").empty() ? "" : "; ") + text("note"))});
  }
  return table;
}

std::string passed_text(const ordered_json& rows) {
  const auto n = std::count_if(rows.begin(), rows.end(), [](const auto& row) { return row.at("verdict") == "pass"; });
  return fmt::format("{} of {} rows pass.", n, rows.size());
}

}  // namespace

Filling suite_section(const ordered_json& json) {
  const auto& rows = json.at("rows");
  const bool pass = json.at("summary").at("pass").get<bool>();
  const auto text_or_nothing = [&](const char* key) { return json.at(key).is_string() ? json[key] : Filling(""); };
  return {{"template", "suite"},
          {"suite", text_or_nothing("suite")},
          {"about", text_or_nothing("about")},
          {"badge", pass ? "good" : "bad"},
          {"verdict", pass ? "pass" : "fail"},
          {"summary", summary_text(json.at("summary"))},
          {"quantities", filling_of(quantities_table(json.at("quantities")))},
          {"figures", filling_of(suite_figures(json))},
          {"cases", counted(rows.size(), "case")},
          {"rows", filling_of(cases_table(rows))}};
}

std::string suite_text(const ordered_json& json) {
  const auto& summary = json.at("summary");
  return fmt::format("{}{}\n{}\n{}: {}\n",
                     has_all_rows(json) ? "" : fmt::format("the worst of {}\n", summary.at("cases").get<std::size_t>()),
                     text_of(cases_table(json.at("rows"))), text_of(quantities_table(json.at("quantities"))),
                     summary.at("pass").get<bool>() ? "pass" : "FAIL", summary_text(summary));
}

Filling convergence_section(const ordered_json& rows) {
  return {{"template", "exact"}, {"passed", passed_text(rows)}, {"table", filling_of(convergence_table(rows))}};
}

std::string convergence_text(const ordered_json& rows) {
  return text_of(convergence_table(rows)) + passed_text(rows) + "\n";
}

}  // namespace fretval
