#include "comparison/report/drawing/zone_map.h"

#include <fmt/format.h>

#include <cmath>

#include "comparison/support/escape.h"

namespace fretval {
namespace {

constexpr double width = 480, height = 320, left = 52, bottom = 40, top = 28, right = 14;

const char* colour_of(char zone) {
  switch (zone) {
    case 's':
      return "#14284f";
    case 'f':
      return "#c26a00";
    case 'b':
      return "#3a9bd0";
    default:
      return "#ffffff";
  }
}

std::string axes(double end, const std::string& x_label, const std::string& label) {
  std::string svg = fmt::format(
      "<g font-size=\"12\" fill=\"#5b6573\"><text x=\"{:.0f}\" y=\"{:.0f}\" text-anchor=\"middle\">{}</text>"
      "<text transform=\"translate(14 {:.0f}) rotate(-90)\" text-anchor=\"middle\">{}</text>",
      (left + width - right) / 2, height - 6, html_escaped(x_label), (top + height - bottom) / 2, html_escaped(label));
  for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0})
    svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.0f}\" text-anchor=\"middle\">{:g}</text>",
                       left + t * (width - left - right), height - bottom + 16, t);
  for (double r = 0; r <= end; r += end / 4)
    svg += fmt::format("<text x=\"{:.0f}\" y=\"{:.1f}\" text-anchor=\"end\">{:.2g}</text>", left - 6,
                       height - bottom - r / end * (height - bottom - top) + 4, r);
  return svg + "</g>";
}

/// What the colours are.
std::string key() {
  std::string svg;
  double x = left;
  for (const auto& [zone, name] : {std::pair{'s', "sticks"}, std::pair{'f', "slips forward"},
                                   std::pair{'b', "slips backward"}, std::pair{'o', "open"}}) {
    svg += fmt::format(
        "<rect x=\"{:.0f}\" y=\"6\" width=\"16\" height=\"10\" stroke=\"#858d97\" style=\"fill:{}\"/>"
        "<text x=\"{:.0f}\" y=\"15\" font-size=\"12\" fill=\"#1a2230\">{}</text>",
        x, colour_of(zone), x + 21, name);
    x += 108;
  }
  return svg;
}

/// Radii with their names, c and a.
std::string marks(const Filling& map, double scale) {
  std::string svg;
  for (const auto& mark : map.value("marks", Filling::array())) {
    const double y = height - bottom - scale * mark.at("x").get<double>();
    svg += fmt::format(
        "<line x1=\"{0}\" x2=\"{1}\" y1=\"{2:.1f}\" y2=\"{2:.1f}\" stroke=\"#858d97\" stroke-width=\"1.5\" "
        "stroke-dasharray=\"6 4\"/><text x=\"{3}\" y=\"{4:.1f}\" font-size=\"12\" fill=\"#1a2230\">{5}</text>",
        left, width - right, y, width - right + 3, y + 4, html_escaped(mark.at("name").get<std::string>()));
  }
  return svg;
}

}  // namespace

std::vector<double> outer_edges(const std::vector<double>& radii, double unit) {
  std::vector<double> edges;
  double square = 0;
  for (const double r : radii) edges.push_back(std::sqrt(square = 2 * r * r / (unit * unit) - square));
  return edges;
}

Filling zone_map(const std::string& title, const std::string& label, const std::vector<double>& edges,
                 const std::vector<std::string>& zones) {
  return {{"kind", "map"},    {"title", title}, {"x_label", "time over the period"},
          {"y_label", label}, {"edges", edges}, {"zones", zones}};
}

std::string zone_map_svg(const Filling& map) {
  const auto edges = map.at("edges").get<std::vector<double>>();
  const auto zones = map.at("zones").get<std::vector<std::string>>();
  const double end = edges.empty() ? 1 : edges.back();
  const double step = (width - left - right) / static_cast<double>(zones.size()), scale = (height - bottom - top) / end;
  std::string svg = fmt::format("<svg viewBox=\"0 0 {:.0f} {:.0f}\" role=\"img\" aria-label=\"{}\">", width, height,
                                html_escaped(map.at("title").get<std::string>()));
  for (std::size_t k = 0; k < zones.size(); ++k)
    for (std::size_t i = 0, begin = 0; i < zones[k].size(); ++i) {
      if (i + 1 < zones[k].size() && zones[k][i + 1] == zones[k][i]) continue;
      const double inner = begin == 0 ? 0 : edges[begin - 1], outer = edges[i];
      if (zones[k][i] != 'o')
        svg += fmt::format(
            "<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"{}\" "
            "shape-rendering=\"crispEdges\"/>",
            left + step * static_cast<double>(k), height - bottom - scale * outer, step + 0.2, scale * (outer - inner),
            colour_of(zones[k][i]));
      begin = i + 1;
    }
  return svg +
         fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#5b6573\"/>", left, top,
                     width - left - right, height - bottom - top) +
         key() + marks(map, scale) +
         axes(end, map.at("x_label").get<std::string>(), map.at("y_label").get<std::string>()) + "</svg>";
}

}  // namespace fretval
