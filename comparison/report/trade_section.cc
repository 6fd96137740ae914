#include "comparison/report/trade_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <vector>

#include "comparison/case/case.h"
#include "comparison/report/trade_figures.h"
#include "comparison/support/escape.h"

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

std::string number_text(const Json& value, const char* format) {
  return value.is_number() ? fmt::format(fmt::runtime(format), value.get<double>()) : "–";
}

std::string row(const std::string& first, const std::string& second, const Json& point, bool bad) {
  const auto& s = point.at("setting");
  const auto& memory = point.at("memory_bytes");
  return fmt::format(
      "<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td{}>{}</td><td>{:.2f}</td>"
      "<td>{}</td></tr>\n",
      first, second, s.at("rings_per_radius").get<int>(), s.at("element_order").get<int>(),
      number_text(s.at("grading"), "{:g}"), number_text(s.at("far_radius"), "{:g}"), s.at("steps_per_cycle").get<int>(),
      bad ? " class=\"bad-cell\"" : "", number_text(point.at("error"), "{:.1e}"),
      point.at("seconds").at("total").get<double>(),
      memory.is_number() ? fmt::format("{:.0f}", memory.get<double>() / 1e6) : "–");
}

std::string recommendations_table(const Json& trade) {
  std::string html =
      "<div class=\"scroll\"><table><thead><tr><th>tolerance</th><th></th><th>rings</th><th>order</th><th>grading</th>"
      "<th>far radius</th><th>steps</th><th>error</th><th>seconds</th><th>MB</th></tr></thead><tbody>\n";
  const auto& points = trade.at("points");
  for (const auto& r : trade.at("recommendations")) {
    const auto tolerance = number_text(r.at("tolerance"), "{:.0e}");
    html += r.at("cheapest").is_number()
                ? row(tolerance, "cheapest", points.at(r["cheapest"].get<std::size_t>()), false)
                : fmt::format("<tr><td>{}</td><td>no setting meets it</td></tr>\n", tolerance);
    html += row(tolerance, "chosen by the tool", points.at(r.at("chosen").get<std::size_t>()),
                !r.at("chosen_meets_tolerance").get<bool>());
  }
  return html + "</tbody></table></div>\n";
}

std::string slope_text(const Json& slope) {
  if (slope.is_null()) return "–";
  return fmt::format("{:.2f} ({})", slope.at("power").get<double>(), slope.at("points").get<int>());
}

std::string rates_table(const Json& trade) {
  std::string html =
      "<div class=\"scroll\"><table><thead><tr><th>error ~ x<sup>p</sup> over</th><th>p, largest error</th>"
      "<th>first slip</th><th>shakedown</th><th>contact radius</th><th>normal force</th></tr></thead><tbody>\n";
  for (const auto& [name, rate] : trade.at("rates").items()) {
    html += fmt::format("<tr><td>{}</td><td>{}</td>", html_escaped(name), slope_text(rate.at("largest_error")));
    for (const char* key :
         {"stick_radius_first_slip", "stick_radius_shakedown", "contact_radius_max", "normal_force_max"})
      html += fmt::format("<td>{}</td>", slope_text(rate.at("quantities").value(key, Json())));
    html += "</tr>\n";
  }
  return html + fmt::format(
                    "</tbody></table></div>\n<p class=\"soft\">Least squares over the errors, coarsest first, down to "
                    "three times "
                    "the smallest one of the sweep, their number in parentheses; – : fewer than two of them. Seconds "
                    "grow with the power {} "
                    "of the rings.</p>\n",
                    slope_text(trade.at("seconds_over_rings")));
}

std::string full_text(const Json& trade) {
  std::string html;
  for (const auto& level : trade.at("full")) {
    const auto& difference = level.at("largest_relative_difference_from_condensed");
    if (!difference.is_object()) continue;
    const auto& measured = level.at("measured");
    const auto& condensed = trade.at("points").at(level.at("condensed_point").get<std::size_t>());
    html += fmt::format(
        "<p>With all {} degrees of freedom as unknowns ({} rings per radius), {} normal and {} tangential steps were "
        "measured: {:.3f} s and {:.3f} s each. Pressures and tractions differ by at most {:.1e} and {:.1e} from the "
        "condensed ones. The whole history would take {:.1f} s (extrapolated), condensed it takes {:.2f} s.</p>\n",
        level.at("dofs").get<int>(), level.at("setting").at("rings_per_radius").get<int>(),
        measured.at("normal_steps").get<long>(), measured.at("friction_steps").get<long>(),
        measured.at("seconds_per_normal_step").get<double>(), measured.at("seconds_per_friction_step").get<double>(),
        difference.at("pressure").get<double>(), difference.at("traction").get<double>(),
        level.at("seconds_of_the_whole_history_extrapolated_from_the_measured_steps").get<double>(),
        condensed.at("seconds").at("total").get<double>());
  }
  return html;
}

std::string trade_html(const Json& trade) {
  std::string html = fmt::format(
      "<h2>Speed and accuracy: {}</h2>\n<p>The closed form takes {:.1e} s, {:.1e} s of them for the stick radii. {} "
      "settings of "
      "the finite elements, each against it:</p>\n",
      html_escaped(trade.at("name").get<std::string>()), trade.at("closed_form").at("seconds").get<double>(),
      trade.at("closed_form").at("stick_radii_seconds").get<double>(), trade.at("points").size());
  html += recommendations_table(trade);
  html +=
      "<p class=\"soft\">A tolerance holds for the stick radii over the contact radius, a tenth of it for contact "
      "radius and normal force; the error shown is the largest of all.</p>\n";
  return html + figures_html(trade_figures(trade)) + full_text(trade) + rates_table(trade);
}

}  // namespace

std::string trade_section(const fs::path& folder) {
  std::string html;
  for (const auto& file : trades_below(folder)) {
    std::ifstream stream(file);
    try {
      html += trade_html(Json::parse(stream));
    } catch (const nlohmann::json::exception& error) {
      throw InputError(fmt::format("{}: {}", file.string(), error.what()));
    }
  }
  return html;
}

}  // namespace fretval
