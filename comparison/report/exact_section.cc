#include "comparison/report/exact_section.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "comparison/support/escape.h"

namespace fretval {
namespace {

using nlohmann::ordered_json;

std::string number_or_dash(const ordered_json& value, const char* dash) {
  return value.is_number() ? fmt::format("{:.1e}", value.get<double>()) : std::string(dash);
}

std::string errors_cells(const ordered_json& row) {
  std::string cells;
  const auto& resolutions = row.at("resolutions");
  const auto& errors = row.at("errors");
  for (std::size_t i = 0; i < errors.size(); ++i)
    cells += fmt::format("<td title=\"{} {}\">{}</td>", resolutions.at(i).get<int>(),
                         html_escaped(row.at("refined").get<std::string>()), number_or_dash(errors[i], "not finite"));
  return cells;
}

std::string convergence_row_html(const ordered_json& row) {
  const bool pass = row.at("verdict").get<std::string>() == "pass";
  const auto& goal = row.at("goal");
  const std::string goal_text = goal.is_number() ? fmt::format("{:.0e}, {}", goal.get<double>(),
                                                               row.at("goal_met").get<bool>() ? "met" : "not met")
                                                 : "–";
  const auto& order = row.at("observed_order");
  return fmt::format(
      "<tr><td>{}: {}</td>{}<td>{} ({:.0f})</td><td>{:.0e}</td><td>{}</td><td{}>{}</td><td class=\"words\">{}{}{}</td>"
      "</tr>\n",
      html_escaped(row.at("solution").get<std::string>()), html_escaped(row.at("quantity").get<std::string>()),
      errors_cells(row), order.is_number() ? fmt::format("{:.1f}", order.get<double>()) : "floor",
      row.at("expected_order").get<double>(), row.at("tolerance").get<double>(), goal_text,
      pass ? "" : " class=\"bad-cell\"", html_escaped(row.at("verdict").get<std::string>()),
      html_escaped(row.at("source").get<std::string>()), row.at("note").get<std::string>().empty() ? "" : "; ",
      html_escaped(row.at("note").get<std::string>()));
}

}  // namespace

std::string convergence_section(const ordered_json& rows) {
  std::size_t n_pass = 0, n_goals = 0, n_met = 0;
  std::string body;
  for (const auto& row : rows) {
    n_pass += row.at("verdict").get<std::string>() == "pass" ? 1 : 0;
    if (row.at("goal").is_number()) ++n_goals;
    if (row.at("goal_met").is_boolean() && row.at("goal_met").get<bool>()) ++n_met;
    body += convergence_row_html(row);
  }
  return fmt::format(
      "<h2>Verification: finite elements against exact solutions</h2>\n<p>{} of {} rows pass; {} of {} goals of the "
      "project are met. Errors are relative, the largest over the positions of the edges within their rings, on four "
      "nested resolutions: 16, 32, 64 and 128 rings per contact radius where nothing else is said (hover over an "
      "error "
      "to see). To repeat: <code>fretval check --suite exact</code>.</p>\n<div class=\"scroll\"><table><thead><tr>"
      "<th>solution: quantity</th><th colspan=\"4\">errors, refined from left to right</th><th>order (expected)</th>"
      "<th>tolerance</th><th>goal</th><th>verdict</th><th>source; note</th></tr></thead><tbody>\n{}</tbody></table>"
      "</div>\n",
      n_pass, rows.size(), n_met, n_goals, body);
}

}  // namespace fretval
