#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "comparison/report/drawing/figures.h"
#include "comparison/report/drawing/plots.h"
#include "comparison/support/constants.h"

namespace fretval {
namespace {

using Numbers = std::vector<double>;

struct Points {
  Numbers x, y;
};

/// A closed line around the centre, whose radius is linear in the angle between the given ones.
Points outline(const Numbers& angles, const Numbers& radii, double unit) {
  constexpr int n_between = 8;
  Points line;
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const std::size_t next = (i + 1) % angles.size();
    const double gap = next > 0 ? angles[next] - angles[i] : angles.front() + 2 * pi - angles[i];
    for (int k = 0; k <= n_between; ++k) {
      const double share = static_cast<double>(k) / n_between, angle = angles[i] + share * gap,
                   radius = (radii[i] + share * (radii[next] - radii[i])) / unit;
      line.x.push_back(radius * std::cos(angle));
      line.y.push_back(radius * std::sin(angle));
    }
  }
  return line;
}

/// Adds an arrow by (x, y) from its tail, with two barbs, and a gap behind it.
void add_arrow(double tail_x, double tail_y, double x, double y, Points& arrows) {
  constexpr double along = 0.3, aside = 0.16;  // of a barb, over the length of the arrow
  const double tip_x = tail_x + x, tip_y = tail_y + y;
  const auto add = [&](double px, double py) {
    arrows.x.push_back(px);
    arrows.y.push_back(py);
  };
  add(tail_x, tail_y);
  for (const double side : {aside, -aside}) {
    add(tip_x, tip_y);
    add(tip_x - along * x - side * y, tip_y - along * y + side * x);
  }
  add(tip_x, std::nan(""));
}

/// Tractions at the end of the cycle: of points that stick in it, and of those that slip.
struct Arrows {
  Points stuck, slipping;
};

Arrows arrows_of(const StoredResult& r, double unit) {
  const auto file = r.folder / "surface.csv";
  const auto column = [&](const char* name) { return read_columns(file, "angle [rad]", name); };
  const auto [angle, inner] = column("r inner [m]");
  const auto outer = column("r outer [m]").second, p = column("p [Pa]").second, x = column("t_x [Pa]").second,
             y = column("t_y [Pa]").second, sticks = column("sticks in a cycle [1]").second;
  double largest = 0, contact = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    largest = std::max(largest, std::hypot(x[i], y[i]));
    if (p[i] > 0) contact = std::max(contact, outer[i]);
  }
  const auto n_around = static_cast<double>(std::count(inner.begin(), inner.end(), inner.front()));
  Arrows arrows;
  constexpr double distance = 9;  // arrows per contact radius, and the longest of them over their distance
  double next = 0;
  std::size_t of_ring = 0;  // the point's number on its ring
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double middle = (inner[i] + outer[i]) / 2, around = 2 * pi * middle * distance / contact;
    of_ring = i > 0 && inner[i] == inner[i - 1] ? of_ring + 1 : 0;
    if (of_ring == 0 && inner[i] >= next + contact / distance) next = inner[i];
    const auto stride = static_cast<std::size_t>(std::max(1.0, std::ceil(n_around / std::max(around, 1.0))));
    if (inner[i] != next || of_ring % stride != 0 || !(p[i] > 0) || !(largest > 0)) continue;
    const double scale = 1.2 * contact / distance / largest / unit;
    add_arrow(middle * std::cos(angle[i]) / unit, middle * std::sin(angle[i]) / unit, scale * x[i], scale * y[i],
              sticks[i] > 0 ? arrows.stuck : arrows.slipping);
  }
  return arrows;
}

PlaneEdges edges_in(const StoredResult& r) {
  const auto file = r.folder / "zones.csv";
  const auto column = [&](const char* name) { return read_columns(file, "angle [rad]", name); };
  auto [angle, contact] = column("contact [m]");
  PlaneEdges edges{std::move(angle), std::move(contact), column("never slipped [m]").second, {}};
  if (!is_pass(r.motion_kind())) edges.sticks_in_a_cycle = column("sticks in a cycle [m]").second;
  return edges;
}

/// radius: m, that has to have room.
Plot plot_of(const char* title, double radius, const Axis& length) {
  Plot plot{title, "x in " + length.unit, "y in " + length.unit};
  plot.equal_scales = true;
  const double half = 1.08 * radius / length.factor;
  plot.y_range = {-half, half};
  plot.x_range = {-half, half};
  return plot;
}

void add(const char* label, Points points, Series::Style style, int colour, Plot& plot) {
  plot.series.push_back({label, std::move(points.x), std::move(points.y), style, colour});
}

constexpr int colour_of_contact = 7, colour_of_cycle = 2, colour_of_never = 3;

void add_edges(const PlaneEdges& edges, const Axis& length, Plot& plot) {
  const auto line = [&](const Numbers& radii) { return outline(edges.angle, radii, length.factor); };
  add("contact", line(edges.contact), Series::Style::line, colour_of_contact, plot);
  if (!edges.sticks_in_a_cycle.empty())
    add("sticks in a cycle", line(edges.sticks_in_a_cycle), Series::Style::line, colour_of_cycle, plot);
  add("has never slipped", line(edges.never_slipped), Series::Style::line, colour_of_never, plot);
}

void add_circle(const char* label, const std::optional<double>& radius, const Axis& length, int colour, Plot& plot) {
  constexpr std::size_t n_around = 32;
  if (!radius) return;
  Numbers angles(n_around);
  for (std::size_t k = 0; k < n_around; ++k) angles[k] = 2 * pi * static_cast<double>(k) / n_around;
  add(label, outline(angles, Numbers(n_around, *radius), length.factor), Series::Style::dashed, colour, plot);
}

}  // namespace

Figure edges_figure(const PlaneEdges& edges, const MdrRadii& mdr) {
  const Numbers larger{
      std::max(mdr.contact.value_or(0), *std::max_element(edges.contact.begin(), edges.contact.end()))};
  const auto length = axis_for({&larger}, "m");
  auto plot = plot_of("Zones from above", larger.front(), length);
  add_edges(edges, length, plot);
  add_circle("contact by MDR", mdr.contact, length, colour_of_contact, plot);
  if (!edges.sticks_in_a_cycle.empty())
    add_circle("sticks in a cycle by MDR", mdr.sticks_in_a_cycle, length, colour_of_cycle, plot);
  add_circle("has never slipped by MDR", mdr.never_slipped, length, colour_of_never, plot);
  return {std::move(plot),
          "Solid: finite elements for the case as it is. Dashed: MDR's own model, which has discs alone."};
}

Figure plane_figure(const StoredResult& r) {
  const auto edges = edges_in(r);
  const auto length = axis_for({&edges.contact}, "m");
  auto plot =
      plot_of("Zones and tractions from above", *std::max_element(edges.contact.begin(), edges.contact.end()), length);
  auto [stuck, slipping] = arrows_of(r, length.factor);
  if (!slipping.x.empty()) add("traction where it slips", std::move(slipping), Series::Style::line, 1, plot);
  if (!stuck.x.empty()) add("traction where it sticks", std::move(stuck), Series::Style::line, 0, plot);
  add_edges(edges, length, plot);
  return {std::move(plot), std::string("The contact at the end of the ") +
                               (is_pass(r.motion_kind()) ? "pass" : "last cycle") +
                               ". Arrows: the traction of the indenter on the body."};
}

}  // namespace fretval
