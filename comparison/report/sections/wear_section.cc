#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "comparison/report/drawing/figures.h"
#include "comparison/report/drawing/plots.h"
#include "comparison/report/sections/sections.h"
#include "comparison/report/text/numbers.h"
#include "comparison/report/text/table.h"
#include "comparison/results/answer_text.h"
#include "comparison/support/json.h"

namespace fretval {
namespace {

using Results = std::vector<StoredResult>;
using nlohmann::ordered_json;
using Numbers = std::vector<double>;

constexpr std::size_t few_courses = 3;  // that are printed

const ordered_json* wear_of(const StoredResult& r) {
  const auto& fe = r.json.at("fe");
  const auto found = fe.find("wear");
  return found == fe.end() ? nullptr : &*found;
}

const ordered_json* mdr_wear_of(const StoredResult& r) {
  const auto& mdr = r.json.at("mdr");
  const auto found = mdr.find("wear");
  return found == mdr.end() ? nullptr : &*found;
}

double length_of(const StoredResult& r) {
  return r.number("scene", "contact_radius_unworn");
}

double depth_of(const StoredResult& r) {
  return r.number("scene", "indentation_max");
}

std::string law_text(const StoredResult& r) {
  const auto& law = r.json.at("scene").at("wear_law");
  const auto name = law.at("law").get<std::string>();
  return name == "power" ? fmt::format("p^{:g}", law.at("exponent").get<double>()) : name;
}

std::string end_text(const ordered_json& wear) {
  if (wear.value("sticks_throughout", false)) return "all that touches sticks";
  if (!wear.value("slip_is_proved", true)) return "no slip is proved";
  if (wear.at("ends_in_limit").get<bool>()) return "nothing wears any more";
  const auto end = wear.at("end").get<std::string>();
  if (end == "rate fallen") return "the rate has fallen";
  if (end == "progressive") return "it goes on for ever";
  if (end == "contact slides") return "the whole contact slides";
  return end == "nothing left" ? "all that is pressed sticks" : end;
}

/// "2.3e+05, 56 h": up to the last one.
std::string cycles_text(const StoredResult& r, const ordered_json& wear) {
  const double cycles = wear.at("cycles").back().get<double>();
  const auto period = period_of(r.json.at("scene"));
  return fmt::format("{:.2g}", cycles) + (period ? ", " + time_text(*period * cycles) : "");
}

/// "0.0123 mm³, 0.99992"
std::string volumes_text(const ordered_json& wear) {
  const double volume = wear.at("volume").back().get<double>();
  return fmt::format("{:.3g} mm³, {:.5f}", 1e9 * volume, volume / wear.at("volume_of_limit").get<double>());
}

Table table_of(const Results& results) {
  Table table{{"case", "body, law", "c", "distance from the limit", "… of the first-slip radius", "a∞, MDR",
               "difference", "volume worn, over that of the limit", "difference from MDR", "cycles, time", "end"}};
  for (const auto& r : results) {
    const auto* wear = wear_of(r);
    if (!wear) continue;
    const auto& distance = wear->at("distance_to_limit");
    table.rows.push_back({r.name(), words_cell(r.text("scene", "rheology") + ", " + law_text(r)),
                          length_text(r, "fe", "stick_radius_shakedown"), number_text(distance.at("shakedown")),
                          number_text(distance.at("first_slip")), length_text(r, "mdr", "worn_radius"),
                          difference_with_bar(r, "worn_radius"), words_cell(volumes_text(*wear)),
                          difference_with_bar(r, "worn_volume"), words_cell(cycles_text(r, *wear)),
                          words_cell(end_text(*wear))});
  }
  return table;
}

/// Some points of a curve, at equal distances along it.
Series thinned(const Series& series, double distance) {
  Series few = series;
  few.x.clear();
  few.y.clear();
  for (std::size_t i = 0; i < series.x.size(); ++i)
    if (few.x.empty() || std::hypot(series.x[i] - few.x.back(), series.y[i] - few.y.back()) >= distance) {
      few.x.push_back(series.x[i]);
      few.y.push_back(series.y[i]);
    }
  return few;
}

/// Whether wear has ended in a limit that MDR has for it.
bool is_in_limit(const ordered_json& wear) {
  return wear.at("ends_in_limit").get<bool>() && wear.value("limit_is_reached", true) &&
         wear.value("slip_is_proved", true);
}

/// Figure of all cases of one shape that have worn to their end: limits as lines, worn profiles as points, with a
/// colour for each stick radius.
Figure claim_figure(const Results& results, const std::string& shape) {
  Plot plot{fmt::format("{}: where wear ends", shape), "r / a_0", "f / d_{max}"};
  std::vector<double> radii;
  const auto colour_of = [&](double c) {
    std::size_t i = 0;
    while (i < radii.size() && std::abs(radii[i] - c) > 2e-3) ++i;
    if (i == radii.size()) radii.push_back(c);
    return static_cast<int>(i);
  };
  for (const auto& r : results) {
    const auto* wear = wear_of(r);
    if (!wear || r.text("scene", "shape") != shape || !is_in_limit(*wear)) continue;
    const double c = r.number("mdr", "stick_radius_shakedown") / length_of(r);
    const auto n_before = radii.size();
    const int colour = colour_of(c);
    if (radii.size() > n_before)
      plot.series.push_back(curve_from(r, "profile.csv", "f limiting [m]", length_of(r), depth_of(r),
                                       {fmt::format("c = {:.2f} a_0", c), {}, {}, Series::Style::line, colour}));
    plot.series.push_back(thinned(curve_from(r, "worn_profile.csv", "f [m]", length_of(r), depth_of(r),
                                             {"", {}, {}, Series::Style::points, colour}),
                                  0.05));
  }
  plot.x_range = {0, 1.5};
  plot.y_range = {0, 1.2};
  return {std::move(plot),
          "Lines: the limiting profiles of MDR's shakedown radii. Points: the indenters that finite elements have worn "
          "until nothing wears any more, whatever the law of wear, its coefficient and the rheology. In units of the "
          "unworn contact radius and the largest indentation, as in the paper."};
}

/// The axes of the plots of a case: of radii and of heights.
std::pair<Axis, Axis> axes_of(const StoredResult& r) {
  const Numbers length{length_of(r)}, depth{depth_of(r)};
  return {axis_for({&length}, "m"), axis_for({&depth}, "m")};
}

/// Figure with a slider over the states of the course, which shows the last one at first.
Filling sequence_figure(const StoredResult& r) {
  const auto [length, depth] = axes_of(r);
  const auto height = [&, length = length.factor, depth = depth.factor](const char* file, const std::string& column,
                                                                        const Series& look) {
    return curve_from(r, file, column, length, depth, look);
  };
  Plot plot{"Profile in the course of wear", "r in " + length.unit, "f in " + depth.unit};
  plot.marks = radius_marks(r, length);
  plot.x_range = {0, 1.5 * length_of(r) / length.factor};
  plot.y_range = {0, 1.2 * depth_of(r) / depth.factor};
  auto frames = Filling::array(), names = Filling::array();
  for (const auto& column : column_names(r.folder / "wear.csv")) {
    if (column.rfind("f after", 0) != 0) continue;
    if (plot.series.empty()) {
      plot.series.push_back(height("wear.csv", column, {"finite elements", {}, {}, Series::Style::line, 1}));
      plot.series.push_back(height("wear.csv", column, {"unworn", {}, {}, Series::Style::line, 0}));
    } else {
      plot.series.front().y = height("wear.csv", column, {}).y;
    }
    frames.push_back(plot.series.front().y);
    names.push_back(column.substr(2, column.size() - 6));
  }
  plot.series.push_back(height("profile.csv", "f limiting [m]", {"limit, MDR", {}, {}, Series::Style::dashed, 7}));
  auto json = json_of(plot);
  if (!names.empty())
    json["frames"] = {
        {"label", "state"}, {"start", names.size() - 1}, {"y", Filling::array({frames})}, {"names", names}};
  return {{"plot", std::move(json)},
          {"caption",
           "What finite elements have worn, at any of some states of the course. Dashed: the limiting profile."}};
}

Figure volume_figure(const StoredResult& r, const ordered_json& wear) {
  Plot plot{"Worn volume", "cycles", "over that of the limiting profile"};
  plot.log_x = true;
  const double unit = wear.at("volume_of_limit").get<double>();
  if (const auto* mdr = mdr_wear_of(r))
    plot.series.push_back(over_cycles(*mdr, "volume", unit, {"MDR", {}, {}, Series::Style::line, 0}));
  plot.series.push_back(over_cycles(wear, "volume", unit, {"finite elements", {}, {}, Series::Style::points, 1}));
  std::string caption = "Points: the jumps of the finite elements over many cycles.";
  if (const auto difference = number_in(wear, "springs_difference"))
    caption += fmt::format(" From the springs of MDR they differ by up to {} of the limit's volume.",
                           number_text(*difference));
  return {std::move(plot), std::move(caption)};
}

Figure distance_figure(const ordered_json& wear) {
  Plot plot{"Distance from the limiting profile", "cycles", "in r / a_0 and f / d_{max}"};
  plot.log_x = plot.log_y = true;
  plot.series.push_back(over_cycles(wear, "distance_to_shakedown_limit", 1,
                                    {"of the shakedown radius", {}, {}, Series::Style::line_points, 1}));
  plot.series.push_back(over_cycles(wear, "distance_to_first_slip_limit", 1,
                                    {"of the first-slip radius", {}, {}, Series::Style::line_points, 0}));
  return {std::move(plot), "Largest distance of a ring of the worn profile from either curve."};
}

Figure pressure_figure(const StoredResult& r) {
  const auto length = axes_of(r).first;
  const auto at_start = read_columns(r.folder / "wear.csv", "r [m]", "p largest at start [Pa]").second;
  const auto stress = axis_for({&at_start}, "Pa");
  Plot plot{"Largest pressure in the cycle", "r in " + length.unit, "p in " + stress.unit};
  plot.marks = radius_marks(r, length);
  int colour = 0;
  for (const char* when : {"at start", "in the middle", "at end"}) {
    auto [radius, pressure] = read_columns(r.folder / "wear.csv", "r [m]", fmt::format("p largest {} [Pa]", when));
    Series series{when, {}, {}, Series::Style::line, colour++};
    series.x = length.of(radius);
    series.y = stress.of(pressure);
    plot.series.push_back(std::move(series));
  }
  plot.x_range = {0, 1.5 * length_of(r) / length.factor};
  const auto& start = plot.series.front().y;
  plot.y_range = {0, start.empty() ? 1 : 3 * *std::max_element(start.begin(), start.end())};
  return {std::move(plot),
          "In the middle half of the volume is worn off. At the end the pressure is singular at the edge of the stick "
          "zone, and nothing beyond."};
}

Filling course(const StoredResult& r, const ordered_json& wear) {
  auto figures = filling_of(std::vector<Figure>{volume_figure(r, wear), pressure_figure(r), distance_figure(wear)});
  figures["figures"].insert(figures["figures"].begin(), sequence_figure(r));
  const auto length = axes_of(r).first;
  const auto edges = outer_edges(wear.at("r").get<Numbers>(), length.factor);
  for (const char* when : {"start", "end"})
    figures["figures"].push_back(
        {{"plot", zone_map(fmt::format("Stick, slip and open, {} of the wear", when), "r in " + length.unit, edges,
                           wear.at("zones").at(when).get<std::vector<std::string>>())},
         {"caption", "What each ring does in a cycle."}});
  return {{"name", r.name()}, {"figures", std::move(figures)}};
}

/// Numbers of the template.
Filling findings(const Results& results) {
  int n = 0, n_limit = 0, n_elsewhere = 0, n_stuck = 0, n_unproved = 0, n_progressive = 0;
  double farthest = 0, nearest_first_slip = std::numeric_limits<double>::infinity();
  for (const auto& r : results) {
    const auto* wear = wear_of(r);
    if (!wear) continue;
    ++n;
    if (wear->value("sticks_throughout", false))
      ++n_stuck;
    else if (!wear->value("slip_is_proved", true))
      ++n_unproved;
    if (wear->value("end", "") == "progressive") ++n_progressive;
    if (!wear->value("limit_is_reached", true) && wear->value("end", "") != "progressive") ++n_elsewhere;
    if (!is_in_limit(*wear)) continue;
    ++n_limit;
    const auto& distance = wear->at("distance_to_limit");
    const double shakedown = distance.at("shakedown"), first_slip = distance.at("first_slip");
    farthest = std::max(farthest, shakedown);
    // Where both radii are the same, so are the limits.
    if (first_slip > 2 * shakedown) nearest_first_slip = std::min(nearest_first_slip, first_slip);
  }
  Filling found{{"limits", fmt::format("{} of {} {} worn to it.", n_limit,
                                       counted(static_cast<std::size_t>(n), "indenter"), n == 1 ? "has" : "have")}};
  if (n_elsewhere > 0) found["elsewhere"] = n_elsewhere;
  if (n_stuck > 0) found["stuck"] = n_stuck;
  if (n_unproved > 0) found["unproved"] = n_unproved;
  if (n_progressive > 0) found["progressive"] = n_progressive;
  if (n_limit > 0) found["farthest"] = number_text(farthest);
  if (std::isfinite(nearest_first_slip)) found["nearest"] = number_text(nearest_first_slip, "{:.2g}");
  return found;
}

}  // namespace

Filling wear_section(const Results& results) {
  const auto table = table_of(results);
  if (table.rows.empty()) return nullptr;
  std::vector<Figure> claims;
  std::set<std::string> shapes, families;
  auto courses = Filling::array();
  for (const auto& r : results) {
    const auto* wear = wear_of(r);
    if (!wear) continue;
    if (is_in_limit(*wear) && shapes.insert(r.text("scene", "shape")).second)
      claims.push_back(claim_figure(results, r.text("scene", "shape")));
    if (families.insert(r.family()).second) courses.push_back(course(r, *wear));
  }
  auto filling = findings(results);
  filling["template"] = "wear";
  filling["claims"] = filling_of(claims);
  filling["table"] = filling_of(table);
  filling["long"] = courses.size() > few_courses;
  filling["courses"] = std::move(courses);
  return filling;
}

}  // namespace fretval
