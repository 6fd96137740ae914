#include "comparison/report/trade_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "comparison/accuracy/quantity.h"
#include "comparison/support/escape.h"

namespace fretval {
namespace {

using Json = nlohmann::ordered_json;

constexpr int front_colour = 7, spring_colour = 6, full_colour = 3, closed_form_colour = 5;

double as_double(const Json& value) {
  return value.is_number() ? value.get<double>() : std::nan("");
}

double seconds_of(const Json& point) {
  return as_double(point.at("seconds"));
}

double megabytes_of(const Json& point) {
  return as_double(point.at("memory_bytes")) / 1e6;
}

void add(Series& series, double x, double y) {
  if (!std::isfinite(x) || !std::isfinite(y)) return;
  series.x.push_back(x);
  series.y.push_back(y);
}

bool is_in(const Json& point, const char* sweep) {
  const auto& sweeps = point.at("sweeps");
  return std::find(sweeps.begin(), sweeps.end(), sweep) != sweeps.end();
}

/// All points by element order, and the front as a line.
template <class Cost>
std::vector<Series> clouds(const Json& trade, const Cost& cost) {
  std::map<int, Series> by_order;
  for (const auto& point : trade.at("points")) {
    const int order = point.at("setting").at("degree").get<int>();
    auto& series = by_order[order];
    series.label = fmt::format("order {}", order);
    series.style = Series::Style::points;
    series.colour = order - 2;
    add(series, cost(point), as_double(point.at("error")));
  }
  std::vector<Series> all;
  all.reserve(by_order.size());
  for (auto& [order, series] : by_order) all.push_back(std::move(series));
  return all;
}

Series front_line(const Json& trade) {
  Series front{"front", {}, {}, Series::Style::line, front_colour};
  for (const auto& i : trade.at("front")) {
    const auto& point = trade.at("points").at(i.get<std::size_t>());
    add(front, seconds_of(point), as_double(point.at("error")));
  }
  return front;
}

Plot log_plot(std::string title, std::string x_label) {
  Plot plot;
  plot.title = std::move(title);
  plot.x_label = std::move(x_label);
  plot.y_label = "largest error";
  plot.log_x = plot.log_y = true;
  return plot;
}

std::pair<double, double> error_span(const std::vector<Series>& all) {
  double least = 1, largest = 0;
  for (const auto& series : all)
    for (const double y : series.y)
      if (y > 0) least = std::min(least, y), largest = std::max(largest, y);
  return {least, largest};
}

Series all_dofs(const char* label) {
  return {label, {}, {}, Series::Style::triangles, full_colour};
}

/// unit: that the cost is multiplied by.
void add_levels(Plot& plot, Series series, const Json& levels, const char* cost, const char* error, double unit = 1) {
  for (const auto& level : levels) add(series, unit * as_double(level.at(cost)), as_double(level.at(error)));
  if (!series.x.empty()) plot.series.push_back(std::move(series));
}

Figure cost_figure(const Json& trade) {
  auto plot = log_plot("Error over time", "seconds");
  plot.series = clouds(trade, seconds_of);
  plot.series.push_back(front_line(trade));
  add_levels(plot, {"springs in time", {}, {}, Series::Style::open_points, spring_colour}, trade.at("springs"),
             "seconds", "error");
  add_levels(plot, all_dofs("all dofs, extrapolated"), trade.at("full"), "extrapolated_seconds",
             "error_of_the_condensed_point");
  plot.key_rows = 4;
  const auto [least, largest] = error_span(plot.series);
  const double seconds = as_double(trade.at("closed_form").at("seconds"));
  plot.series.push_back(
      {"closed form: error 0", {seconds, seconds}, {least, largest}, Series::Style::dashed, closed_form_colour});
  return {std::move(plot),
          fmt::format("{}: largest error over all compared quantities against the closed form of MDR, over "
                      "the seconds of a setting (body and its own histories). No setting on the front is "
                      "beaten in both. With all dofs the error is that of the condensed elements, which "
                      "they equal; their time is extrapolated from a few measured steps.",
                      html_escaped(trade.at("name").get<std::string>()))};
}

Figure memory_figure(const Json& trade) {
  auto plot = log_plot("Error over memory", "MB");
  plot.series = clouds(trade, megabytes_of);
  add_levels(plot, all_dofs("all dofs"), trade.at("full"), "memory_bytes", "error_of_the_condensed_point", 1e-6);
  return {
      std::move(plot),
      "Memory: measured peak growth of the process while the body was made, and the counted size of the histories."};
}

struct Axis {
  const char* sweep;
  const char* key;  ///< of the setting
  const char* title;
};
constexpr Axis axes[] = {{"rings", "elements_per_radius", "rings per contact radius"},
                         {"time step", "steps_per_cycle", "steps per cycle"},
                         {"far field", "far_radius", "far radius over a"},
                         {"grading", "growth", "grading"},
                         {"element order", "degree", "element order"}};

std::vector<Json> members(const Json& trade, const Axis& axis) {
  std::vector<Json> list;
  for (const auto& point : trade.at("points"))
    if (is_in(point, axis.sweep) && point.at("error").is_number()) list.push_back(point);
  std::sort(list.begin(), list.end(), [&](const Json& a, const Json& b) {
    return as_double(a.at("setting").at(axis.key)) < as_double(b.at("setting").at(axis.key));
  });
  return list;
}

std::string rate_text(const Json& trade, const Axis& axis) {
  const auto& rates = trade.at("rates");
  if (!rates.contains(axis.sweep) || rates[axis.sweep].at("largest_error").is_null()) return "";
  const auto& slope = rates[axis.sweep]["largest_error"];
  return fmt::format(" Largest error: power {:.2f}, from {} points.", slope.at("power").get<double>(),
                     slope.at("points").get<int>());
}

Figure axis_figure(const Json& trade, const Axis& axis, const std::vector<Json>& points) {
  auto plot = log_plot(fmt::format("Error over {}", axis.title), axis.title);
  plot.y_label = "error";
  int colour = 0;
  for (const auto quantity : quantities_by_interest) {
    const char* key = name_of(quantity);
    Series line{traits_of(quantity).label, {}, {}, Series::Style::line, colour},
        marks{"", {}, {}, Series::Style::points, colour};
    for (const auto& point : points) {
      if (!point.at("errors").contains(key)) continue;
      const double x = as_double(point.at("setting").at(axis.key)), y = as_double(point.at("errors").at(key));
      add(line, x, y);
      add(marks, x, y);
    }
    ++colour;
    if (line.x.empty()) continue;
    plot.series.push_back(line);
    plot.series.push_back(marks);
  }
  for (const auto& point : points) plot.x_tics.push_back(as_double(point.at("setting").at(axis.key)));
  plot.x_range = {plot.x_tics.front() / 1.15, plot.x_tics.back() * 1.15};
  return {std::move(plot),
          fmt::format("One axis alone, the others at the reference setting.{}", rate_text(trade, axis))};
}

}  // namespace

std::vector<Figure> trade_figures(const Json& trade) {
  std::vector<Figure> figures{cost_figure(trade)};
  for (const auto& axis : axes) {
    const auto points = members(trade, axis);
    if (points.size() > 1) figures.push_back(axis_figure(trade, axis, points));
  }
  const auto& points = trade.at("points");
  if (std::any_of(points.begin(), points.end(), [](const Json& p) { return std::isfinite(megabytes_of(p)); }))
    figures.push_back(memory_figure(trade));
  return figures;
}

}  // namespace fretval
