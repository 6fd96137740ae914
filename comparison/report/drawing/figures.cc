#include "comparison/report/drawing/figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "comparison/report/drawing/plots.h"
#include "comparison/run/sweep_line.h"

namespace fretval {
namespace {

constexpr const char* phase_entry = "Motion / Phase";
constexpr const char* ratio_entry = "Wear / Stick radius ratio";

struct Criterion {
  const char* key;
  const char* name;
};
constexpr Criterion first_slip{"stick_radius_first_slip", "first-slip radius (the paper's criterion)"};
constexpr Criterion shakedown{"stick_radius_shakedown", "shakedown radius (the steady state)"};

double amplitude_ratio(const StoredResult& r) {
  return 1.5 * r.number("scene", "friction_coefficient") * r.number("scene", "normal_amplitude") /
         r.number("scene", "tangential_amplitude");
}

std::string shape_title(const std::string& shape) {
  if (shape == "parabola") return "Parabola";
  return shape == "cone" ? "Cone" : "Power law";
}

using Members = std::vector<const StoredResult*>;

/// The results that are swept over an entry, by shape, in the paper's order.
std::vector<std::pair<std::string, Members>> swept_by_shape(const std::vector<StoredResult>& results,
                                                            const char* entry) {
  std::vector<std::pair<std::string, Members>> shapes;
  for (const char* shape : {"parabola", "cone", "power"}) {
    Members members;
    for (const auto& r : results)
      if (r.swept_over(entry) && r.has_one_frequency() && !r.has_forces() && r.text("scene", "shape") == shape)
        members.push_back(&r);
    if (!members.empty()) shapes.emplace_back(shape, std::move(members));
  }
  return shapes;
}

/// A curve of a phase sweep: everything of one k and rheology.
struct CurveKey {
  double k;
  std::string rheology;
  bool operator<(const CurveKey& o) const { return std::tie(k, rheology) < std::tie(o.k, o.rheology); }
};

std::map<CurveKey, Members> curves(const Members& results) {
  std::map<CurveKey, Members> grouped;
  for (const auto* r : results)
    grouped[{std::round(1e6 * amplitude_ratio(*r)) / 1e6, r->text("scene", "rheology")}].push_back(r);
  return grouped;
}

/// The sweep with the most points of each k carries the line; the others only add points.
std::map<double, CurveKey> leading_curves(const std::map<CurveKey, Members>& grouped) {
  std::map<double, CurveKey> leading;
  for (const auto& [key, members] : grouped) {
    const auto found = leading.find(key.k);
    if (found == leading.end() || grouped.at(found->second).size() < members.size()) leading[key.k] = key;
  }
  return leading;
}

int colour_of(const std::map<double, CurveKey>& leading, double k) {
  return static_cast<int>(std::distance(leading.begin(), leading.find(k)));
}

/// MDR also between the points, where those are of one sweep that has them.
Series with_values_between(const Series& line, const Members& members, const Criterion& criterion) {
  const auto of_the_first = [&](const StoredResult* r) { return r->family() == members.front()->family(); };
  if (!std::all_of(members.begin(), members.end(), of_the_first)) return line;
  auto [phase, radius] =
      read_sweep_line(members.front()->folder.parent_path(), phase_entry, *quantity_of(criterion.key));
  if (phase.empty()) return line;
  for (double& r : radius) r /= members.front()->number("scene", "contact_radius_at_rest");
  Series fine = line;
  fine.x = std::move(phase);
  fine.y = std::move(radius);
  return fine;
}

Figure stick_radius_figure(const Members& results, const std::string& shape, const Criterion& criterion) {
  Plot plot{fmt::format("{}: {}", shape_title(shape), criterion.name), "phase φ_0 in degrees",
            "c over the contact radius at d_0"};
  const auto grouped = curves(results);
  const auto leading = leading_curves(grouped);
  std::set<std::string> rheologies;
  for (const auto& [key, members] : grouped) {
    const bool leads = leading.at(key.k).rheology == key.rheology;
    const int colour = colour_of(leading, key.k);
    Series line{fmt::format("k = {:g}", key.k), {}, {}, Series::Style::line, colour};
    Series points{"", {}, {}, leads ? Series::Style::points : Series::Style::open_points, colour};
    for (const auto* r : members) {
      const double unit = r->number("scene", "contact_radius_at_rest");
      line.x.push_back(r->sweep_value());
      line.y.push_back(r->number("mdr", criterion.key) / unit);
      points.x.push_back(r->sweep_value());
      points.y.push_back(r->number("fe", criterion.key) / unit);
    }
    if (leads) plot.series.push_back(with_values_between(line, members, criterion));
    plot.series.push_back(points);
    rheologies.insert(key.rheology);
  }
  plot.x_range = {0, 180};
  plot.y_range = {0, 0.9};
  auto caption = fmt::format(
      "{}. Lines: MDR. Full points: finite elements, {}; open points: the other rheologies with the same modulus "
      "ratio. Rheologies shown: {}. A missing point: nothing sticks.",
      plot.title, leading.begin()->second.rheology, fmt::join(rheologies, ", "));
  return {std::move(plot), std::move(caption)};
}

Figure difference_figure(const Members& results, const std::string& shape) {
  Plot plot{fmt::format("{}: difference between finite elements and MDR", shape_title(shape)), "phase φ_0 in degrees",
            "|c_{FE} - c_{MDR}| / a"};
  plot.log_y = true;
  const auto grouped = curves(results);
  const auto leading = leading_curves(grouped);
  for (const auto& criterion : {first_slip, shakedown}) {
    std::map<double, Series> per_k;
    for (const auto& [key, members] : grouped) {
      auto& series = per_k[key.k];
      const bool first = criterion.key == first_slip.key;
      series.style = first ? Series::Style::open_points : Series::Style::points;
      series.label = first ? "" : fmt::format("k = {:g}", key.k);
      series.colour = colour_of(leading, key.k);
      for (const auto* r : members) {
        series.x.push_back(r->sweep_value());
        series.y.push_back(std::abs(r->number("fe", criterion.key) - r->number("mdr", criterion.key)) /
                           r->number("scene", "contact_radius_unworn"));
      }
    }
    for (auto& [k, series] : per_k) plot.series.push_back(std::move(series));
  }
  const double tolerance = results.front()->number("scene", "tolerance");
  plot.series.push_back({"tolerance", {0, 180}, {tolerance, tolerance}, Series::Style::dashed, 7});
  plot.x_range = {0, 180};
  plot.y_range = {1e-6, 1e-1};
  return {std::move(plot), "The same cases, all rheologies. Full points: shakedown, open points: first slip."};
}

/// Free surface of the finite elements at the largest indentation, up to the outer radius, about 25 points.
Series thinned_surface(const StoredResult& r, double outer, double length, double depth, int colour) {
  const auto [radius, height] = read_columns(r.folder / "contact.csv", "r outer [m]", "surface height at d max [m]");
  Series points{"", {}, {}, Series::Style::points, colour};
  for (std::size_t i = 0; i < radius.size() && radius[i] <= outer * length; ++i) {
    if (!points.x.empty() && radius[i] / length < points.x.back() + outer / 25) continue;
    points.x.push_back(radius[i] / length);
    points.y.push_back(height[i] / depth);
  }
  return points;
}

Figure limiting_profile_figure(const Members& results, const std::string& shape) {
  Plot plot{fmt::format("{}: limiting profiles", shape_title(shape)), "r / a_0", "f_∞ / d_{max}"};
  int colour = 0;
  Series ends{"", {}, {}, Series::Style::triangles, 7};
  for (const auto* r : results) {
    const double length = r->number("scene", "contact_radius_unworn");
    const double depth = r->number("scene", "indentation") + r->number("scene", "normal_amplitude");
    auto [x, y] = read_columns(r->folder / "profile.csv", "r [m]", "f limiting [m]");
    for (double& v : x) v /= length;
    for (double& v : y) v /= depth;
    const double outer = r->number("mdr", "worn_radius") / length;
    for (std::size_t i = 1; i < x.size(); ++i)
      if (x[i - 1] <= outer && outer < x[i]) {
        ends.x.push_back(outer);
        ends.y.push_back(y[i - 1] + (y[i] - y[i - 1]) * (outer - x[i - 1]) / (x[i] - x[i - 1]));
      }
    plot.series.push_back(
        {fmt::format("c = {:.2g} a_0", r->sweep_value()), std::move(x), std::move(y), Series::Style::line, colour});
    plot.series.push_back(thinned_surface(*r, outer, length, depth, colour++));
  }
  plot.series.push_back(std::move(ends));
  plot.x_range = plot.y_range = {0, 1.6};
  return {std::move(plot),
          "Lines: the profiles that MDR predicts, which are the indenters of the finite element runs. Points: the "
          "surface of the finite elements at the largest indentation, which must lie on them without pressure outside "
          "c. Triangles: a∞, where the wear ends."};
}

}  // namespace

Filling filling_of(const std::vector<Figure>& figures) {
  Filling filling{{"template", "figures"}, {"figures", Filling::array()}};
  for (const auto& figure : figures)
    filling["figures"].push_back({{"plot", json_of(figure.plot)}, {"caption", figure.caption}});
  return filling;
}

std::vector<Figure> stick_radius_figures(const std::vector<StoredResult>& results) {
  std::vector<Figure> figures;
  for (const auto& [shape, members] : swept_by_shape(results, phase_entry))
    for (const auto& criterion : {first_slip, shakedown})
      figures.push_back(stick_radius_figure(members, shape, criterion));
  return figures;
}

std::vector<Figure> difference_figures(const std::vector<StoredResult>& results) {
  std::vector<Figure> figures;
  for (const auto& [shape, members] : swept_by_shape(results, phase_entry))
    figures.push_back(difference_figure(members, shape));
  return figures;
}

std::vector<Figure> limiting_profile_figures(const std::vector<StoredResult>& results) {
  std::vector<Figure> figures;
  for (const auto& [shape, members] : swept_by_shape(results, ratio_entry))
    figures.push_back(limiting_profile_figure(members, shape));
  return figures;
}

Series curve_from(const StoredResult& r, const char* file, const std::string& column, double length, double depth,
                  const Series& look) {
  auto [radius, height] = read_columns(r.folder / file, "r [m]", column);
  Series series = look;
  series.x = Axis{"", length}.of(radius);
  series.y = Axis{"", depth}.of(height);
  return series;
}

Series over_cycles(const Filling& wear, const char* key, double unit, const Series& look) {
  Series series = look;
  const auto cycles = wear.at("cycles").get<std::vector<double>>(), values = wear.at(key).get<std::vector<double>>();
  for (std::size_t i = 1; i < cycles.size(); ++i) {
    series.x.push_back(cycles[i]);
    series.y.push_back(values[i] / unit);
  }
  return series;
}

}  // namespace fretval
