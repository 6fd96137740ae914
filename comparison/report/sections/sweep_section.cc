#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "comparison/quantities/quantity.h"
#include "comparison/report/drawing/figures.h"
#include "comparison/report/sections/sections.h"
#include "comparison/results/answer_text.h"
#include "comparison/results/case_inputs.h"
#include "comparison/run/sweep_line.h"
#include "comparison/support/files.h"

namespace fretval {
namespace {

using Family = std::vector<const StoredResult*>;

std::map<std::string, Family> families_of(const std::vector<StoredResult>& results) {
  std::map<std::string, Family> families;
  for (const auto& r : results)
    if (!r.sweep().empty()) families[r.family()].push_back(&r);
  return families;
}

std::string entry_of(const Family& family) {
  return family.front()->entry();
}

/// The bar of a quantity that is compared; NaN if none was measured.
double absolute_bar(const StoredResult& r, Quantity quantity) {
  const bool is_compared = r.json.at("comparison").contains(name_of(quantity));
  if (!is_compared) return std::nan("");
  return fe_reading(r.json, quantity).value_or(Reading{}).uncertainty.value_or(std::nan(""));
}

struct Curves {
  std::vector<double> value, mdr, fe, bar;
  std::vector<double> line_value, line;  ///< of MDR, also between the points
  bool has_values_between = false;
  double largest = 0;
};

Curves curves_of(const Family& family, Quantity quantity) {
  Curves curves;
  for (const auto* r : family) {
    curves.value.push_back(r->sweep_value());
    curves.mdr.push_back(r->number("mdr", name_of(quantity)));
    curves.fe.push_back(r->number("fe", name_of(quantity)));
    curves.bar.push_back(absolute_bar(*r, quantity));
    for (const double value : {curves.mdr.back(), curves.fe.back()})
      if (std::isfinite(value)) curves.largest = std::max(curves.largest, std::abs(value));
  }
  std::tie(curves.line_value, curves.line) =
      read_sweep_line(family.front()->folder.parent_path(), entry_of(family), quantity);
  curves.has_values_between = !curves.line.empty();
  if (!curves.has_values_between) std::tie(curves.line_value, curves.line) = std::tie(curves.value, curves.mdr);
  return curves;
}

double largest_value(const Family& family) {
  double largest = 0;
  for (const auto* r : family) largest = std::max(largest, std::abs(r->sweep_value()));
  return largest;
}

/// "Friction / Coefficient, μ"
std::string axis_title(const std::string& entry, const char* prefix) {
  const auto symbol = symbol_of_entry(entry), unit = unit_of_entry(entry);
  return entry + (symbol.empty() ? "" : ", " + symbol) + (unit.empty() ? "" : fmt::format(" in {}{}", prefix, unit));
}

Figure sweep_figure(const Family& family, const std::vector<Quantity>& quantities, const std::string& title) {
  const auto entry = entry_of(family), unit = unit_of_entry(entry);
  const auto [entry_prefix, entry_factor] =
      takes_prefixes(unit) ? prefix_for(largest_value(family)) : UnitPrefix{"", 1};
  Plot plot{title, axis_title(entry, entry_prefix), ""};
  double largest = 0;
  for (const auto quantity : quantities) largest = std::max(largest, curves_of(family, quantity).largest);
  const auto [prefix, factor] = prefix_for(largest);
  plot.y_label =
      fmt::format("{} in {}{}", traits_of(quantities.front()).label, prefix, traits_of(quantities.front()).unit);
  int colour = 0;
  for (const auto quantity : quantities) {
    auto curves = curves_of(family, quantity);
    for (auto* values : {&curves.line, &curves.fe, &curves.bar})
      for (double& value : *values) value /= factor;
    for (auto* values : {&curves.value, &curves.line_value})
      for (double& value : *values) value /= entry_factor;
    plot.series.push_back({fmt::format("{}, MDR", traits_of(quantity).title), curves.line_value, curves.line,
                           curves.has_values_between ? Series::Style::line : Series::Style::dashed, colour});
    plot.series.push_back({fmt::format("{}, finite elements", traits_of(quantity).title), curves.value, curves.fe,
                           Series::Style::points, colour++, curves.bar});
  }
  if (quantities.size() > 1) plot.y_label = fmt::format("stick radius in {}m", prefix);
  return {std::move(plot),
          "Line: MDR; dashed where it is known at the points alone, straight between. Points: finite elements with "
          "their error bars."};
}

bool is_any(const Family& family, Quantity quantity) {
  return curves_of(family, quantity).largest > 0;
}

/// Whether a quantity changes by more than a thousandth: one that does not needs no plot.
bool depends_on_entry(const Family& family, Quantity quantity) {
  const auto curves = curves_of(family, quantity);
  const auto [least, most] = std::minmax_element(curves.mdr.begin(), curves.mdr.end());
  return std::isfinite(*least) && *most - *least > 1e-3 * curves.largest;
}

/// Whether a family is one of the figures of the paper, which show its radii.
bool is_in_the_figures(const Family& family) {
  const auto shape = family.front()->text("scene", "shape");
  const bool of_the_paper = shape == "parabola" || shape == "cone" || shape == "power";
  return (entry_of(family) == "Motion / Phase" && of_the_paper && family.front()->has_one_frequency() &&
          !family.front()->has_forces()) ||
         entry_of(family) == "Wear / Stick radius ratio";
}

/// What the largest contact does by finite elements: all of it sticks for good, a part of it, or none.
enum class Regime { sticks, partial_slip, gross_slip };

/// A stick radius over the contact radius; 0: nothing sticks.
double stick_ratio(const StoredResult& r, const char* side) {
  const double contact = r.number("mdr", "contact_radius_max"), by_fe = r.number("fe", "contact_radius_max");
  const double stick = r.number(side, "stick_radius_shakedown"), a = std::isfinite(by_fe) ? by_fe : contact;
  return std::isfinite(stick) && a > 0 ? stick / a : 0;
}

Regime regime_of(const StoredResult& r) {
  constexpr double nearly_all = 0.9995;  // as of the first sentence of an answer
  const double ratio = stick_ratio(r, "fe");
  return ratio <= 0 ? Regime::gross_slip : ratio >= nearly_all ? Regime::sticks : Regime::partial_slip;
}

/// Square of MDR's stick ratio at each of some cases in the order of their second values, less that of a level. Where
/// nothing sticks behind two that stick, it is what they lead to: for a parabola the square is linear in the amplitude.
std::vector<double> squares_less(const Family& column, double level) {
  std::vector<double> squares;
  for (const auto* r : column) squares.push_back(std::pow(stick_ratio(*r, "mdr"), 2));
  for (std::size_t i = 2; i < squares.size(); ++i)
    if (squares[i] == 0 && squares[i - 1] > 0 && squares[i - 2] > 0) {
      const double step = (column[i]->second_value() - column[i - 1]->second_value()) /
                          (column[i - 1]->second_value() - column[i - 2]->second_value());
      squares[i] = std::min(0.0, squares[i - 1] + step * (squares[i - 1] - squares[i - 2]));
      break;
    }
  for (double& square : squares) square -= level * level;
  return squares;
}

/// Where MDR's stick ratio is a level, one place for each value of the entry.
Series level_of(const Family& family, double level, double x_factor, double y_factor, int colour) {
  Series line{level > 0 ? fmt::format("c = {:g} a, MDR", level) : "nothing sticks from here on, MDR",
              {},
              {},
              Series::Style::line,
              colour};
  std::map<double, Family> columns;
  for (const auto* r : family) columns[r->sweep_value()].push_back(r);
  for (const auto& [value, column] : columns) {
    const auto squares = squares_less(column, level);
    for (std::size_t i = 0; i + 1 < column.size(); ++i) {
      if ((squares[i] > 0) == (squares[i + 1] > 0)) continue;
      const double here = column[i]->second_value(), next = column[i + 1]->second_value();
      line.x.push_back(value / x_factor);
      line.y.push_back((here + (next - here) * squares[i] / (squares[i] - squares[i + 1])) / y_factor);
      break;
    }
  }
  return line;
}

/// Range of an axis, with room around the points.
std::pair<double, double> range_around(const std::vector<Series>& all, std::vector<double> Series::*values) {
  double least = HUGE_VAL, most = -HUGE_VAL;
  for (const auto& series : all)
    for (const double value : series.*values) {
      least = std::min(least, value);
      most = std::max(most, value);
    }
  const double room = 0.05 * (most - least) + 1e-9 * std::abs(most);
  return {least - room, most + room};
}

/// A fretting map. family: by both values, as results are read.
Figure regime_map(const Family& family) {
  const auto x_entry = entry_of(family), y_entry = family.front()->second_entry();
  double largest_second = 0;
  for (const auto* r : family) largest_second = std::max(largest_second, std::abs(r->second_value()));
  const auto prefix_of = [](const std::string& entry, double largest) {
    return takes_prefixes(unit_of_entry(entry)) ? prefix_for(largest) : UnitPrefix{"", 1};
  };
  const auto x_prefix = prefix_of(x_entry, largest_value(family)), y_prefix = prefix_of(y_entry, largest_second);
  Plot plot{"Fretting map", axis_title(x_entry, x_prefix.name), axis_title(y_entry, y_prefix.name)};
  const std::vector<std::pair<Regime, Series>> regimes{
      {Regime::sticks, {"all sticks, finite elements", {}, {}, Series::Style::points, 0}},
      {Regime::partial_slip, {"partial slip", {}, {}, Series::Style::open_points, 2}},
      {Regime::gross_slip, {"gross slip: nothing sticks for good", {}, {}, Series::Style::triangles, 1}}};
  for (const auto& [regime, look] : regimes) {
    auto series = look;
    for (const auto* r : family)
      if (regime_of(*r) == regime) {
        series.x.push_back(r->sweep_value() / x_prefix.factor);
        series.y.push_back(r->second_value() / y_prefix.factor);
      }
    if (!series.x.empty()) plot.series.push_back(std::move(series));
  }
  int colour = 5;
  plot.x_range = range_around(plot.series, &Series::x);
  plot.y_range = range_around(plot.series, &Series::y);
  for (const double level : {0.9, 0.5, 0.0}) {
    auto line = level_of(family, level, x_prefix.factor, y_prefix.factor, colour++);
    if (line.x.size() > 1) plot.series.push_back(std::move(line));
  }
  return {std::move(plot),
          "Points: finite elements, each a case. Lines: where MDR's shakedown radius is such a share of the contact "
          "radius, between the cases by its square."};
}

Filling family_filling(const std::string& name, const Family& family) {
  if (!family.front()->second_entry().empty())
    return {{"family", name},
            {"entry", entry_of(family) + " and " + family.front()->second_entry()},
            {"figures", filling_of({regime_map(family)})}};
  std::vector<Figure> figures;
  const auto first_slip = Quantity::stick_radius_first_slip, shakedown = Quantity::stick_radius_shakedown;
  if (!is_in_the_figures(family) && (is_any(family, first_slip) || is_any(family, shakedown)))
    figures.push_back(sweep_figure(family, {first_slip, shakedown}, "Stick radii"));
  for (const auto quantity : {Quantity::contact_radius_max, Quantity::normal_force_max, Quantity::axis_pressure_max,
                              Quantity::indentation_max, Quantity::tangential_amplitude, Quantity::tangential_force_max,
                              Quantity::friction_work, Quantity::bulk_work})
    if (depends_on_entry(family, quantity)) {
      std::string title = traits_of(quantity).title;
      title.front() = static_cast<char>(std::toupper(title.front()));
      figures.push_back(sweep_figure(family, {quantity}, title));
    }
  return {{"family", name}, {"entry", entry_of(family)}, {"figures", filling_of(figures)}};
}

}  // namespace

Filling sweeps_section(const std::vector<StoredResult>& results) {
  auto sweeps = Filling::array();
  const auto families = families_of(results);
  for (const auto& [name, family] : families) {
    if (family.size() == 1 || (families.size() > 1 && is_in_the_figures(family))) continue;
    if (auto filling = family_filling(name, family); !filling.at("figures").at("figures").empty())
      sweeps.push_back(std::move(filling));
  }
  if (sweeps.empty()) return nullptr;
  return {{"template", "sweeps"}, {"sweeps", std::move(sweeps)}};
}

void write_sweeps(const std::vector<StoredResult>& results) {
  for (const auto& [name, family] : families_of(results)) {
    const auto second = family.front()->second_entry();
    std::string text =
        "case," + column_of_entry(entry_of(family)) + (second.empty() ? "" : "," + column_of_entry(second));
    std::vector<Quantity> quantities;
    for (const auto quantity : quantities_by_interest)
      if (is_any(family, quantity)) quantities.push_back(quantity);
    for (const auto quantity : quantities)
      for (const char* who : {" by MDR", " by finite elements", " error bar"}) text += "," + column_of(quantity, who);
    const auto cell = [](double value) { return std::isfinite(value) ? fmt::format("{:.10g}", value) : ""; };
    for (const auto* r : family) {
      text += fmt::format("\n{},{:.10g}", r->name(), r->sweep_value());
      if (!second.empty()) text += fmt::format(",{:.10g}", r->second_value());
      for (const auto quantity : quantities)
        text += fmt::format(",{},{},{}", cell(r->number("mdr", name_of(quantity))),
                            cell(r->number("fe", name_of(quantity))), cell(absolute_bar(*r, quantity)));
    }
    write_file(family.front()->folder.parent_path() / "sweep.csv", text + "\n");
  }
}

}  // namespace fretval
