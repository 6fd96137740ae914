#include "comparison/report/zone_map.h"

#include <fmt/format.h>

#include <cmath>

#include "comparison/support/escape.h"

namespace fretval {
namespace {

constexpr double width = 480, height = 300, left = 52, bottom = 40, top = 8, right = 10;

const char* colour_of(char zone) {
  switch (zone) {
    case 's':
      return "#0072b2";
    case 'f':
      return "#e69f00";
    case 'b':
      return "#f0e442";
    default:
      return "#ffffff";
  }
}

/// Outer edges of rings from the radii that halve their areas.
std::vector<double> outer_edges(const std::vector<double>& radii) {
  std::vector<double> edges;
  double square = 0;
  for (const double r : radii) edges.push_back(std::sqrt(square = 2 * r * r - square));
  return edges;
}

std::string axes(double end) {
  std::string svg = fmt::format(
      "<g font-size=\"12\" fill=\"#5b6573\"><text x=\"{:.0f}\" y=\"{:.0f}\" text-anchor=\"middle\">time over the "
      "period</text><text transform=\"translate(14 {:.0f}) rotate(-90)\" text-anchor=\"middle\">r / a₀</text>",
      (left + width - right) / 2, height - 6, (top + height - bottom) / 2);
  for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0})
    svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.0f}\" text-anchor=\"middle\">{:g}</text>",
                       left + t * (width - left - right), height - bottom + 16, t);
  for (double r = 0; r <= end; r += 0.25)
    svg += fmt::format("<text x=\"{:.0f}\" y=\"{:.1f}\" text-anchor=\"end\">{:g}</text>", left - 6,
                       height - bottom - r / end * (height - bottom - top) + 4, r);
  return svg + "</g>";
}

}  // namespace

std::string zone_map_figure(const std::string& title, const std::vector<double>& radii, double unit,
                            const std::vector<std::string>& zones) {
  const auto edges = outer_edges(radii);
  const double end = edges.empty() ? 1 : edges.back() / unit;
  const double step = (width - left - right) / static_cast<double>(zones.size()), scale = (height - bottom - top) / end;
  std::string svg = fmt::format("<svg viewBox=\"0 0 {:.0f} {:.0f}\" role=\"img\" aria-label=\"{}\">", width, height,
                                html_escaped(title));
  for (std::size_t k = 0; k < zones.size(); ++k)
    for (std::size_t i = 0, begin = 0; i < zones[k].size(); ++i) {
      if (i + 1 < zones[k].size() && zones[k][i + 1] == zones[k][i]) continue;
      const double inner = begin == 0 ? 0 : edges[begin - 1] / unit, outer = edges[i] / unit;
      if (zones[k][i] != 'o')
        svg += fmt::format("<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"{}\"/>",
                           left + step * static_cast<double>(k), height - bottom - scale * outer, step + 0.2,
                           scale * (outer - inner), colour_of(zones[k][i]));
      begin = i + 1;
    }
  svg += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#5b6573\"/>", left, top,
                     width - left - right, height - bottom - top);
  return "<figure>" + svg + axes(end) +
         fmt::format(
             "</svg><figcaption>{}. Blue sticks, orange slips forward, yellow backward, white is open.</figcaption>"
             "</figure>\n",
             html_escaped(title));
}

}  // namespace fretval
