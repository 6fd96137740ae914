#include "comparison/report/trade_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "comparison/accuracy/quantity.h"
#include "comparison/report/table.h"
#include "comparison/report/trade_figures.h"
#include "comparison/results/results_folder.h"
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

std::string megabytes(const Json& bytes) {
  return bytes.is_number() ? fmt::format("{:.0f}", bytes.get<double>() / 1e6) : "–";
}

std::vector<Cell> row_of(const std::string& name, const Json& level, const Json& error, const Json& seconds,
                         bool is_bad = false) {
  const auto& setting = level.at("setting");
  std::vector<Cell> row{name};
  for (const char* key : {"elements_per_radius", "degree", "growth", "far_radius", "steps_per_cycle"})
    row.emplace_back(number_text(setting.value(key, Json()), "{:g}"));
  row.push_back(bad_if(is_bad, number_text(error)));
  row.emplace_back(number_text(seconds, "{:.3g}"));
  row.emplace_back(megabytes(level.value("memory_bytes", Json())));
  return row;
}

std::vector<Cell> row_of(const std::string& name, const Json& point, bool is_bad = false) {
  return row_of(name, point, point.at("error"), point.at("seconds"), is_bad);
}

/// The recommended settings beside the tool's own, the front, and the other levels.
Table settings_table(const Json& trade) {
  Table table{{"", "rings", "order", "grading", "far radius", "steps", "error", "seconds", "MB"}};
  const auto point = [&](const Json& index) { return trade.at("points").at(index.get<std::size_t>()); };
  for (const auto& r : trade.at("recommendations")) {
    const auto tolerance = number_text(r.at("tolerance"), "{:.0e}");
    table.rows.push_back(r.at("cheapest").is_number() ? row_of("cheapest for " + tolerance, point(r["cheapest"]))
                                                      : std::vector<Cell>{"no setting of the plan meets " + tolerance});
    const bool meets = r.at("chosen_meets_tolerance").get<bool>();
    table.rows.push_back(row_of(fmt::format("chosen by the tool for {}{}", tolerance, meets ? "" : ", too coarse"),
                                point(r.at("chosen")), !meets));
  }
  for (const auto& index : trade.at("front")) table.rows.push_back(row_of("front", point(index)));
  for (const auto& level : trade.at("springs"))
    table.rows.push_back(row_of(fmt::format("{} springs", level.at("setting").at("springs").get<int>()), level));
  for (const auto& level : trade.at("full"))
    table.rows.push_back(row_of(fmt::format("all {} dofs, extrapolated", level.at("dofs").get<int>()), level,
                                level.at("error_of_the_condensed_point"), level.at("extrapolated_seconds")));
  return table;
}

std::string slope_text(const Json& slope) {
  if (slope.is_null()) return "–";
  return fmt::format("{:.2f} ({})", slope.at("power").get<double>(), slope.at("points").get<int>());
}

Table rates_table(const Json& trade) {
  Table table{{"error ~ x^p over", "p, largest error"}};
  std::vector<const char*> keys;
  for (const auto quantity : quantities_by_interest) {
    if (!trade.at("rates").front().at("quantities").contains(name_of(quantity))) continue;
    keys.push_back(name_of(quantity));
    table.heads.emplace_back(traits_of(quantity).label);
  }
  for (const auto& [axis, rate] : trade.at("rates").items()) {
    std::vector<Cell> row{axis, slope_text(rate.at("largest_error"))};
    for (const char* key : keys) row.emplace_back(slope_text(rate.at("quantities").value(key, Json())));
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::string closed_form_text(const Json& trade) {
  const auto& closed_form = trade.at("closed_form");
  return fmt::format("The closed form takes {:.1e} s, {:.1e} s of them for the stick radii.",
                     closed_form.at("seconds").get<double>(), closed_form.at("stick_radii_seconds").get<double>());
}

constexpr const char* rates_note =
    "Least squares over the errors, coarsest first, down to three times the smallest one of the axis; their number in "
    "parentheses, – : fewer than two of them.";

std::string trade_html(const Json& trade) {
  return fmt::format(
      "<h2>Speed and accuracy: {}</h2>\n<p>{} {} settings of the finite elements, each against it:</p>\n{}<p "
      "class=\"soft\">A tolerance holds for the stick radii over the contact radius, a tenth of it for contact radius "
      "and normal force; the error shown is the largest of all. With all degrees of freedom as unknowns it is that of "
      "the condensed elements, which they equal, and the seconds are extrapolated from two cycles.</p>\n{}{}<p "
      "class=\"soft\">{}</p>\n",
      html_escaped(trade.at("name").get<std::string>()), closed_form_text(trade), trade.at("points").size(),
      html_of(settings_table(trade)), figures_html(trade_figures(trade)), html_of(rates_table(trade)), rates_note);
}

}  // namespace

std::string trade_text(const Json& trade) {
  return fmt::format("{}\n{}\n{}{}\n", closed_form_text(trade), text_of(settings_table(trade)),
                     text_of(rates_table(trade)), rates_note);
}

std::string trade_section(const fs::path& folder) {
  std::string html;
  for (const auto& file : trades_below(folder)) html += section_of(file, trade_html);
  return html;
}

}  // namespace fretval
