#include "comparison/report/extremes_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "comparison/support/escape.h"

namespace fretval {
namespace {

using nlohmann::ordered_json;

std::string number(const ordered_json& value, const char* format) {
  return value.is_number() ? fmt::format(fmt::runtime(format), value.get<double>()) : "–";
}

/// Cells of MDR and of the finite elements.
std::string pair_cells(const ordered_json& errors, const char* quantity) {
  if (!errors.contains(quantity)) return "<td>–</td><td>–</td>";
  const auto& e = errors.at(quantity);
  return fmt::format("<td>{}</td><td>{}</td>", number(e.at("mdr"), "{:.6f}"), number(e.at("fe"), "{:.6f}"));
}

/// Error, bar and tolerance of the quantity that `worst` names.
std::string worst_cells(const ordered_json& scene) {
  const auto& worst = scene.at("worst");
  if (!worst.is_string()) return "<td>–</td><td>–</td><td>–</td>";
  const auto& e = scene.at("errors").at(worst.get<std::string>());
  return fmt::format("<td title=\"{}\">{}</td><td>{}</td><td>{}</td>", html_escaped(worst.get<std::string>()),
                     number(e.at("error"), "{:.1e}"), number(e.at("bar"), "{:.1e}"),
                     number(e.at("tolerance"), "{:.0e}"));
}

std::string row_html(const ordered_json& scene) {
  const auto verdict = scene.at("verdict").get<std::string>();
  const auto& remark = scene.at("remark");
  return fmt::format("<tr><td>{}: {}</td><td{}>{}</td>{}{}{}<td>{}</td><td class=\"words\">{}</td></tr>\n",
                     html_escaped(scene.at("family").get<std::string>()),
                     html_escaped(scene.at("value").get<std::string>()), verdict == "FAIL" ? " class=\"bad-cell\"" : "",
                     verdict, pair_cells(scene.at("errors"), "stick_radius_first_slip"),
                     pair_cells(scene.at("errors"), "stick_radius_shakedown"), worst_cells(scene),
                     number(scene.at("seconds"), "{:.2f}"),
                     remark.is_string() ? html_escaped(remark.get<std::string>()) : "");
}

}  // namespace

std::string extremes_section(const ordered_json& json) {
  const auto& s = json.at("summary");
  std::string body;
  for (const auto& scene : json.at("scenes")) body += row_html(scene);
  return fmt::format(
      "<h2>Extremes</h2>\n<p>{} scenes at the ends of every parameter: {} agree, {} are refused by name as they "
      "have to be, {} are inconclusive (right within an error bar that is wider than the tolerance), {} fail. Stick "
      "radii "
      "over the contact radius; error, bar and tolerance of the quantity closest to its tolerance (hover over the "
      "error to see which). To repeat: <code>fretval check --suite extremes</code>.</p>\n"
      "<details><summary>All scenes</summary>\n<div class=\"scroll\"><table><thead><tr><th>family: scene</th>"
      "<th>verdict</th><th>first slip, MDR</th><th>FE</th><th>shakedown, MDR</th><th>FE</th><th>error</th>"
      "<th>bar</th><th>tolerance</th><th>seconds</th><th>remark</th></tr></thead><tbody>\n{}</tbody></table></div>"
      "</details>\n",
      s.at("scenes").get<int>(), s.at("agree").get<int>(), s.at("refused").get<int>(), s.at("inconclusive").get<int>(),
      s.at("fail").get<int>(), body);
}

}  // namespace fretval
