#include "comparison/report/sections/case_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparison/report/drawing/case_figures.h"
#include "comparison/report/drawing/sketch.h"
#include "comparison/report/text/numbers.h"
#include "comparison/report/text/table.h"
#include "comparison/results/answer_text.h"

namespace fretval {
namespace {

using nlohmann::ordered_json;

/// A value that nobody has a bar for, by both methods; not there unless finite elements have it.
void add_row(Table& table, const char* title, double fe, double mdr, const char* unit) {
  if (!(fe > 0)) return;
  const auto shown = [&](double value) {
    const auto [prefix, factor] = prefix_for(value);
    return value > 0 ? fmt::format("{:.4g} {}{}", value / factor, prefix, unit) : "–";
  };
  table.rows.push_back({title, shown(fe), shown(mdr), ""});
}

/// Of finite elements alone.
Table table_beyond_mdr(const Answer& answer) {
  Table table{{"quantity", "finite elements"}};
  table.label = "the answer";
  for (const auto& row : answer.rows) table.rows.push_back({row.title, row.fe});
  return table;
}

Table answer_table(const StoredResult& r, const Answer& answer) {
  if (r.is_beyond_mdr()) return table_beyond_mdr(answer);
  Table table{{"quantity", "finite elements", "MDR", "difference"}};
  table.label = "the answer";
  for (const auto& [title, fe, mdr, difference, passes] : answer.rows)
    table.rows.push_back({title, fe, mdr, bad_if(!passes, difference)});
  if (!r.json.at("comparison").contains(name_of(Quantity::friction_work)))
    add_row(table, "energy lost to friction per period", r.number("fe", "friction_work"), std::nan(""), "J");
  if (std::isnan(r.number("fe", "worn_radius")) && r.number("mdr", "worn_radius") > 0)
    table.rows.push_back({"wear ends at the radius a∞", "", with_unit(r.number("mdr", "worn_radius"), 0, "m"), ""});
  return table;
}

std::string value_text(const ordered_json& value, const std::string& unit) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_array()) {
    std::string text;
    for (const auto& one : value) text += (text.empty() ? "" : ", ") + value_text(one, unit);
    return text;
  }
  if (value.is_null()) return "–";
  const double number = value.get<double>();
  if (unit.empty() || unit == "°" || unit == "Hz")
    return fmt::format("{:g}{}{}", number, unit == "Hz" ? " " : "", unit);
  const auto [prefix, factor] = prefix_for(number);
  return fmt::format("{:.6g} {}{}", number / factor, prefix, unit);
}

/// The entries of the case file by their sections.
ordered_json inputs_of(const ordered_json& scene) {
  auto sections = ordered_json::array();
  for (const auto& input : scene.value("inputs", ordered_json::array())) {
    if (sections.empty() || sections.back().at("section") != input.at("section"))
      sections.push_back({{"section", input.at("section")}, {"entries", ordered_json::array()}});
    sections.back()["entries"].push_back(
        {{"name", input.at("name")}, {"value", value_text(input.at("value"), input.at("unit").get<std::string>())}});
  }
  return sections;
}

double input_number(const ordered_json& scene, const char* name) {
  for (const auto& input : scene.value("inputs", ordered_json::array()))
    if (input.at("name") == name && input.at("value").is_number()) return input["value"].get<double>();
  return std::nan("");
}

/// omega tau of each branch.
std::string branches_text(const ordered_json& scene, double angular_frequency) {
  std::string text;
  for (const auto& input : scene.value("inputs", ordered_json::array()))
    if (input.at("name") == "Branch times")
      for (const auto& time : input.at("value"))
        text += (text.empty() ? "" : ", ") + number_text(angular_frequency * time.get<double>(), "{:.3g}");
  return text;
}

/// Numbers of the template `case`; a group that the case does not have is not shown.
void add_groups(const StoredResult& r, Filling& filling) {
  const auto& scene = r.json.at("scene");
  const double a = r.number("scene", "contact_radius_unworn");
  const auto add = [&](const char* key, double value, const char* format) {
    if (std::isfinite(value)) filling[key] = number_text(value, format);
  };
  const bool oscillates = !scene.contains("path");
  if (oscillates) {
    add("k",
        1.5 * r.number("scene", "friction_coefficient") * r.number("scene", "normal_amplitude") /
            r.number("scene", "tangential_amplitude"),
        "{:.4g}");
    add("rho", r.number("mdr", "modulus_ratio"), "{:.5g}");
    filling["omega_tau"] = branches_text(scene, 2 * std::acos(-1.0) * r.number("scene", "frequency"));
  }
  const double radius = input_number(scene, "Radius");
  add("a_over_r", a / radius, "{:.3g}");
  if (r.text("scene", "shape") == "parabola") add("arc", 100 * std::pow(a / radius, 2) / 4, "{:.2g}");
  add("first_slip", r.number("fe", "stick_radius_first_slip") / a, "{:.4f}");
  add("shakedown", r.number("fe", "stick_radius_shakedown") / a, "{:.4f}");
  for (const char* group : {"k", "rho", "a_over_r", "first_slip", "shakedown"})
    if (filling.contains(group)) filling["has_groups"] = true;
  if (oscillates) add("lift_off", r.number("scene", "normal_amplitude") / r.number("scene", "indentation"), "{:.3g}");
  const auto [x, f] = read_columns(r.folder / "profile.csv", "r [m]", "f unworn [m]");
  const auto at = std::lower_bound(x.begin(), x.end(), a) - x.begin();
  if (at > 0 && at < static_cast<std::ptrdiff_t>(x.size())) {
    const auto i = static_cast<std::size_t>(at);
    add("slope", std::atan((f[i] - f[i - 1]) / (x[i] - x[i - 1])) * 180 / std::acos(-1.0), "{:.2g}");
  }
}

Filling one_case(const StoredResult& r) {
  const auto cycle = read_cycle(r);
  const auto answer = answer_of(r.json);
  const bool pass = r.json.at("pass").get<bool>();
  Filling filling{{"name", r.family()},
                  {"about", r.text("scene", "shape") + ", " + r.text("scene", "rheology")},
                  {"agree", r.is_beyond_mdr() ? "not compared, as MDR does not hold for the profile"
                            : pass            ? "finite elements and MDR agree"
                                              : "they do not agree"},
                  {"table", filling_of(answer_table(r, answer))},
                  {"inputs", inputs_of(r.json.at("scene"))},
                  {"figures", case_figures(r, cycle)}};
  if (const auto& scene = r.json.at("scene"); scene.contains("path") && scene["path"].contains("why_no_shakedown"))
    filling["why_no_shakedown"] = scene["path"]["why_no_shakedown"];
  if (auto sketch = sketch_of(r); !sketch.is_null()) filling["sketch"] = std::move(sketch);
  add_groups(r, filling);
  return filling;
}

}  // namespace

Filling cases_section(const std::vector<StoredResult>& results) {
  auto cases = Filling::array();
  for (const auto& r : results)
    if (!r.json.at("scene").contains("sweep")) cases.push_back(one_case(r));
  if (cases.empty()) return nullptr;
  return {{"template", "cases"}, {"cases", std::move(cases)}};
}

}  // namespace fretval
