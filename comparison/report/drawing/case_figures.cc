#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "comparison/case/case.h"
#include "comparison/quantities/quantity.h"
#include "comparison/report/drawing/figures.h"
#include "comparison/report/drawing/plots.h"
#include "comparison/support/json.h"
#include "comparison/support/statistics.h"

namespace fretval {
namespace {

using nlohmann::ordered_json;
using Numbers = std::vector<double>;

constexpr std::size_t most_points = 720;  // of a history; more are not seen

Numbers column_of(const StoredResult& r, const char* file, const char* x, const char* y) {
  return read_columns(r.folder / file, x, y).second;
}

Numbers numbers_of(const ordered_json& list) {
  return list.get<Numbers>();
}

/// Whether there is a c to speak of.
bool has_stick_radius(const StoredResult& r) {
  return r.number("fe", name_of(lasting_stick_radius(r.motion_kind()))) > 0;
}

/// What captions say of the cycle that finite elements step to the end, and of what sticks in it.
struct CycleWords {
  std::string of_slip, last, motion, loop, sticks, sticks_on_map;
};

CycleWords words_for(const StoredResult& r) {
  const std::string name = r.cycle_name();
  CycleWords words;
  if (is_pass(r.motion_kind()))
    words = {"in the pass",
             "pass",
             "The pass, from rest at its first row.",
             "The pass, from rest. The area below the line is the work of the indenter.",
             " Inside c rings never slip.",
             " Below c it never slips."};
  else
    words = {"per " + name,
             "last " + name,
             r.has_period() ? "The last period, which repeats from then on."
                            : "The last near cycle. The motion itself never repeats; every relation between its phases "
                              "that comes by in the end comes by closely in this cycle, which repeats.",
             "One " + name + ". The area of the loop is the energy lost in it.",
             " Between c and a rings slip in every " + name + ".",
             " Below c it slips no more."};
  if (!has_stick_radius(r)) words.sticks = "", words.sticks_on_map = " Nothing sticks for good.";
  return words;
}

/// Middles of rings, for their mean pressures.
Numbers ring_middles(const Numbers& outer) {
  Numbers middles;
  for (std::size_t i = 0; i < outer.size(); ++i) middles.push_back(0.5 * (outer[i] + (i == 0 ? 0 : outer[i - 1])));
  return middles;
}

bool has_path(const StoredResult& r) {
  return r.json.at("scene").contains("path");
}

bool moves_across(const StoredResult& r) {
  const auto u_y = column_of(r, "history.csv", "t [s]", "u_y [m]");
  return std::any_of(u_y.begin(), u_y.end(), [](double u) { return u != 0; });
}

/// Pressure and traction at every instant; at first at the end of the period, where MDR's are: the largest indentation
/// of an oscillation.
Filling stress_figure(const StoredResult& r, const ordered_json& cycle) {
  const auto middles = ring_middles(numbers_of(cycle.at("r")));
  const double mu = r.number("scene", "friction_coefficient");
  const std::size_t start = cycle.at("t").size() - 1;
  Numbers all;
  for (const auto& p : cycle.at("p")) all.push_back(numbers_of(p).front());
  const auto length = axis_for({&middles}, "m"), stress = axis_for({&all}, "Pa");
  Plot plot{"Pressure and traction", "r in " + length.unit, "stress in " + stress.unit};
  plot.marks = radius_marks(r, length);
  const auto x = length.of(middles);
  for (const auto& [label, style, colour] :
       {std::tuple{"p", Series::Style::line_points, 0}, std::tuple{"τ", Series::Style::line_points, 1},
        std::tuple{"± μ p", Series::Style::dashed, 7}, std::tuple{"", Series::Style::dashed, 7}})
    plot.series.push_back({label, x, x, style, colour});
  auto frames =
      ordered_json::array({ordered_json::array(), ordered_json::array(), ordered_json::array(), ordered_json::array()});
  auto names = ordered_json::array();
  const double period = cycle.at("t").back().get<double>();
  for (std::size_t k = 0; k < cycle.at("t").size(); ++k) {
    const auto p = stress.of(numbers_of(cycle["p"][k])), tau = stress.of(numbers_of(cycle["tau"][k]));
    Numbers limit, opposite;
    for (const double value : p) {
      limit.push_back(mu * value);
      opposite.push_back(-mu * value);
    }
    frames[0].push_back(p);
    frames[1].push_back(tau);
    frames[2].push_back(limit);
    frames[3].push_back(opposite);
    names.push_back(fmt::format("{:.2f} of the {}", cycle["t"][k].get<double>() / period, r.cycle_name()));
  }
  for (std::size_t s = 0; s < 4; ++s) plot.series[s].y = numbers_of(frames[s][start]);
  if (const auto mdr = cycle.find("mdr"); mdr != cycle.end())
    for (const auto& [key, label, colour] :
         {std::tuple{"p", has_path(r) ? "p of MDR at the end" : "p of MDR at the largest depth", 5},
          std::tuple{"tau", "τ of MDR", 4}})
      plot.series.push_back({label, length.of(numbers_of(mdr->at("r"))), stress.of(numbers_of(mdr->at(key))),
                             Series::Style::line, colour});
  const auto words = words_for(r);
  auto json = json_of(plot);
  json["frames"] = {{"label", "instant"}, {"names", names}, {"start", start}, {"y", frames}};
  return {{"plot", json},
          {"wide", true},
          {"caption", fmt::format("Mean values of the rings of the finite elements at any instant of the {}; where τ "
                                  "runs along ± μ p the ring slips.{}",
                                  words.last, words.sticks)}};
}

Filling map_figure(const StoredResult& r, const ordered_json& cycle) {
  const auto edges = numbers_of(cycle.at("r"));
  const auto length = axis_for({&edges}, "m");
  auto map = zone_map("Stick, slip and open", "r in " + length.unit, length.of(edges),
                      cycle.at("zones").get<std::vector<std::string>>());
  map["x_label"] = fmt::format("time over the {}", r.cycle_name());
  for (const auto& [name, x] : radius_marks(r, length)) map["marks"].push_back({{"name", name}, {"x", x}});
  const auto words = words_for(r);
  return {{"plot", std::move(map)},
          {"caption", fmt::format("What each ring does in the {}.{}", words.last, words.sticks_on_map)}};
}

/// A force over the displacement in its direction.
struct Loop {
  const char *title, *x_name, *y_name;
};
constexpr Loop normal_loop{"Normal force over indentation", "d", "F_N"},
    tangential_loop{"Tangential force over displacement", "u_x", "F_x"},
    transverse_loop{"Transverse force over displacement", "u_y", "F_y"};

/// Series of finite elements as points, and of MDR as a line.
Figure loop_figure(const StoredResult& r, const ordered_json& cycle, const Loop& loop) {
  const auto [title, x_name, y_name] = loop;
  auto [x, y] = read_columns(r.folder / "history.csv", fmt::format("{} [m]", x_name), fmt::format("{} [N]", y_name));
  const auto length = axis_for({&x}, "m"), force = axis_for({&y}, "N");
  Plot plot{title, fmt::format("{} in {}", x_name, length.unit), fmt::format("{} in {}", y_name, force.unit)};
  if (const auto mdr = cycle.find("mdr"); mdr != cycle.end())
    plot.series.push_back(
        {"MDR", length.of(numbers_of(mdr->at(x_name))), force.of(numbers_of(mdr->at(y_name))), Series::Style::line, 0});
  plot.series.push_back({"finite elements", length.of(thinned(x, most_points)), force.of(thinned(y, most_points)),
                         Series::Style::points, 1});
  for (auto& series :
       measured_series(r, fmt::format("{} [m]", x_name), fmt::format("{} [N]", y_name), length.factor, force.factor))
    plot.series.push_back(std::move(series));
  return {std::move(plot), words_for(r).loop};
}

/// Several directions over time: a column of history.csv and its name each.
Figure course_figure(const StoredResult& r, const char* title, const std::string& what, const std::string& unit,
                     const std::vector<std::pair<const char*, const char*>>& columns) {
  auto t = thinned(column_of(r, "history.csv", "t [s]", "t [s]"), most_points);
  const double start = t.front();
  for (double& time : t) time -= start;
  std::vector<Numbers> values;
  Numbers all;
  for (const auto& [column, unused] : columns) {
    values.push_back(column_of(r, "history.csv", "t [s]", fmt::format("{} [{}]", column, unit).c_str()));
    all.insert(all.end(), values.back().begin(), values.back().end());
  }
  const auto size = axis_for({&all}, unit), time = axis_for({&t}, "s");
  Plot plot{title, "t in " + time.unit, what + " in " + size.unit};
  for (std::size_t k = 0; k < columns.size(); ++k)
    if (!values[k].empty())
      plot.series.push_back({columns[k].second, time.of(t), size.of(thinned(values[k], most_points)),
                             Series::Style::line, static_cast<int>(k)});
  return {std::move(plot), words_for(r).motion};
}

Figure motion_figure(const StoredResult& r) {
  std::vector<std::pair<const char*, const char*>> columns{{"d", "indentation d"}, {"u_x", "tangential u_x"}};
  if (moves_across(r)) columns.emplace_back("u_y", "transverse u_y");
  return course_figure(r, "Motion of the indenter", "displacement", "m", columns);
}

Figure forces_figure(const StoredResult& r) {
  auto figure =
      course_figure(r, "Forces on the indenter", "force", "N", {{"F_N", "normal F_N"}, {"F_x", "tangential F_x"}});
  const auto normal = column_of(r, "history.csv", "t [s]", "F_N [N]"),
             tangential = column_of(r, "history.csv", "t [s]", "F_x [N]");
  auto t = column_of(r, "history.csv", "t [s]", "t [s]");
  const double start = t.front();
  for (double& instant : t) instant -= start;
  const auto size = axis_for({&normal, &tangential}, "N"), time = axis_for({&t}, "s");
  for (const auto& [column, label] : {std::pair{"F_N [N]", "F_N measured"}, std::pair{"F_x [N]", "F_x measured"}})
    for (auto& series : measured_series(r, "t [s]", column, time.factor, size.factor)) {
      series.label = label;
      figure.plot.series.push_back(std::move(series));
    }
  return figure;
}

Figure slip_figure(const StoredResult& r) {
  const auto [edges, slips] = read_columns(r.folder / "contact.csv", "r outer [m]", "slip per period [m]");
  // Rings that are not touched do not slip.
  const auto middles = ring_middles(edges);
  std::vector<double> radius, slip;
  for (std::size_t i = 0; i < slips.size(); ++i) {
    if (std::isnan(slips[i])) continue;
    radius.push_back(middles[i]);
    slip.push_back(slips[i]);
  }
  const auto length = axis_for({&radius}, "m"), path = axis_for({&slip}, "m");
  const auto words = words_for(r);
  Plot plot{"Slip " + words.of_slip, "r in " + length.unit, "path in " + path.unit};
  plot.marks = radius_marks(r, length);
  plot.series.push_back({"finite elements", length.of(radius), path.of(slip), Series::Style::line_points, 1});
  return {std::move(plot), fmt::format("Length of slip of each ring that is touched in the {}{}.", words.last,
                                       has_stick_radius(r) ? "; none inside c" : "")};
}

/// How slip dies out where nothing slips in the end; none where nothing ever does.
std::vector<Figure> decay_figures(const StoredResult& r, const ordered_json& cycle) {
  const auto decay = cycle.find("slip_decay");
  if (decay == cycle.end()) return {};
  Series series{"finite elements", {}, numbers_of(*decay), Series::Style::line_points, 1};
  if (std::none_of(series.y.begin(), series.y.end(), [](double slip) { return slip > 0; })) return {};
  for (std::size_t i = 0; i < series.y.size(); ++i) series.x.push_back(static_cast<double>(i + 1));
  Plot plot{"Slip inside c dies out",
            fmt::format("{}, from rest on", r.cycle_name()),
            "largest slip / u_{x0}",
            {std::move(series)},
            true};
  const double factor = r.number("fe", "slip_decay"), mdr = r.number("mdr", "slip_decay");
  auto caption = fmt::format(
      "Longest path of slip in a {0} of a ring inside c, the shakedown radius, over the tangential amplitude. The "
      "amplitudes rise during the first {0}s; a {0} without any slip has no point.",
      r.cycle_name());
  if (!std::isnan(factor)) caption += fmt::format(" In the end it falls by the factor {:.4g} a period", factor);
  if (!std::isnan(factor)) caption += std::isnan(mdr) ? "." : fmt::format("; by MDR {:.4g}.", mdr);
  if (const double cycles = r.number("fe", "cycles_to_shakedown"); !std::isnan(cycles))
    caption += fmt::format(" After {:.3g} cycles its mean inside c is below {:g}.", cycles, slip_that_counts_as_none);
  return {{std::move(plot), caption}};
}

Figure profile_figure(const StoredResult& r) {
  const auto [radius, unworn] = read_columns(r.folder / "profile.csv", "r [m]", "f unworn [m]");
  const auto limiting = column_of(r, "profile.csv", "r [m]", "f limiting [m]");
  const auto length = axis_for({&radius}, "m"), height = axis_for({&unworn}, "m");
  Plot plot{"Profile of the indenter", "r in " + length.unit, "f in " + height.unit};
  plot.series.push_back({"unworn", length.of(radius), height.of(unworn), Series::Style::dashed, 7});
  if (!limiting.empty())
    plot.series.push_back({"limiting, MDR", length.of(radius), height.of(limiting), Series::Style::line, 0});
  const double c = r.number("mdr", "stick_radius_shakedown"), end = r.number("mdr", "worn_radius");
  if (c > 0) plot.marks.emplace_back("c", c / length.factor);
  if (const double a = r.number("scene", "contact_radius_unworn"); a > 0)
    plot.marks.emplace_back("a", a / length.factor);
  if (end > 0) plot.marks.emplace_back("a_∞", end / length.factor);
  return {std::move(plot),
          limiting.empty()
              ? "The indenter before anything wears."
              : "The limiting profile is where wear ends: it leaves the unworn one at c and meets it at a∞."};
}

/// Shares of the error bars over the tolerance of each quantity; null if none was measured.
Filling budget_figure(const StoredResult& r) {
  std::vector<std::string> sources;
  std::vector<ShareRow> rows;
  const auto bars = r.json.at("fe").value("error_estimate", ordered_json::object());
  for (const auto& [key, bar] : bars.items())
    if (bar.is_object() && bar.contains("shares"))
      for (const auto& [source, share] : bar["shares"].items())
        if (std::find(sources.begin(), sources.end(), source) == sources.end()) sources.push_back(source);
  for (const auto quantity : quantities_by_interest) {
    const auto bar = bars.find(name_of(quantity));
    const auto& comparison = r.json.at("comparison");
    if (bar == bars.end() || !bar->is_object() || !bar->contains("shares") || !comparison.contains(name_of(quantity)))
      continue;
    const double tolerance = comparison[name_of(quantity)].at("tolerance").get<double>();
    Numbers shares;
    for (const auto& source : sources)
      shares.push_back(number_in(bar->at("shares").value(source, ordered_json::object()), "estimate").value_or(0) /
                       tolerance);
    rows.push_back({traits_of(quantity).title, shares});
  }
  if (rows.empty()) return nullptr;
  return {{"plot", share_bars("Error budget", "error bar over the tolerance (dashed: 1)", sources, rows)},
          {"caption", "What makes up the error bar of each quantity: each source measured by its own refinement."}};
}

}  // namespace

ordered_json read_cycle(const StoredResult& result) {
  const auto file = result.folder / "cycle.json";
  std::ifstream stream(file);
  if (!stream) return ordered_json::object();
  try {
    return ordered_json::parse(stream);
  } catch (const nlohmann::json::exception& error) {
    throw InputError(fmt::format("{}: {}", file.string(), error.what()));
  }
}

Filling case_figures(const StoredResult& result, const ordered_json& cycle) {
  Filling figures{{"template", "figures"}, {"figures", Filling::array()}};
  auto& list = figures["figures"];
  const auto add = [&](const std::vector<Figure>& more) {
    const auto filling = filling_of(more);
    for (const auto& figure : filling.at("figures")) list.push_back(figure);
  };
  try {
    if (!cycle.empty()) {
      list.push_back(stress_figure(result, cycle));
      list.push_back(map_figure(result, cycle));
    }
    if (!column_names(result.folder / "zones.csv").empty()) add({plane_figure(result)});
    const auto courses = column_names(result.folder / "history.csv");
    if (!courses.empty())
      add({motion_figure(result), loop_figure(result, cycle, tangential_loop),
           loop_figure(result, cycle, normal_loop)});
    if (moves_across(result)) add({loop_figure(result, cycle, transverse_loop)});
    const bool measures_over_time = !measured_series(result, "t [s]", "t [s]", 1, 1).empty();
    if ((result.has_forces() || measures_over_time) && !column_names(result.folder / "history.csv").empty())
      add({forces_figure(result)});
    if (!column_names(result.folder / "contact.csv").empty()) add({slip_figure(result)});
    add(decay_figures(result, cycle));
    if (!column_names(result.folder / "profile.csv").empty()) add({profile_figure(result)});
    if (!column_names(result.folder / "moduli.csv").empty()) add({moduli_figure(result)});
    add(trace_figures(result));
  } catch (const nlohmann::json::exception& error) {
    throw InputError(fmt::format("{}: {}", (result.folder / "cycle.json").string(), error.what()));
  }
  if (auto budget = budget_figure(result); !budget.is_null()) list.push_back(std::move(budget));
  return figures;
}

}  // namespace fretval
