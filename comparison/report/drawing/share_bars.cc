#include "comparison/report/drawing/share_bars.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "comparison/report/drawing/palette.h"
#include "comparison/support/escape.h"

namespace fretval {
namespace {

constexpr double picture_width = 640, labels = 210, edge = 20, line = 30, thickness = 16, key_line = 20, below = 44;
constexpr double beyond_the_longest = 1.05;
constexpr std::size_t keys_in_a_line = 4;

std::string text_at(double x, double y, const char* anchor, const std::string& text) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>", x, y, anchor, html_escaped(text));
}

std::string box(double x, double y, double width_of_box, double height, std::size_t source) {
  return fmt::format("<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"{}\"/>", x, y,
                     width_of_box, height, palette_colour(source));
}

std::string upright(double x, double top, double bottom, const char* style) {
  return fmt::format("<line x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1:.1f}\" y2=\"{2:.1f}\" {3}/>", x, top, bottom, style);
}

/// 1, 2 or 5 times a power of ten, of which some five make up a length.
double step_for(double length) {
  const double least = length / 6, power = std::pow(10, std::floor(std::log10(least)));
  for (const double times : {1.0, 2.0, 5.0})
    if (times * power >= least) return times * power;
  return 10 * power;
}

}  // namespace

Filling share_bars(const std::string& title, const std::string& label, const std::vector<std::string>& sources,
                   const std::vector<ShareRow>& rows) {
  Filling bars{
      {"kind", "bars"}, {"title", title}, {"x_label", label}, {"sources", sources}, {"rows", Filling::array()}};
  for (const auto& [name, shares] : rows) bars["rows"].push_back({{"label", name}, {"shares", shares}});
  return bars;
}

std::string share_bars_svg(const Filling& bars) {
  const auto sources = bars.at("sources").get<std::vector<std::string>>();
  double longest = 1;
  for (const auto& row : bars.at("rows")) {
    const auto shares = row.at("shares").get<std::vector<double>>();
    longest = std::max(longest, std::accumulate(shares.begin(), shares.end(), 0.0));
  }
  const double end = beyond_the_longest * longest, scale = (picture_width - labels - edge) / end;
  const double top = key_line * static_cast<double>((sources.size() + keys_in_a_line - 1) / keys_in_a_line) + 12;
  const double bottom = top + line * static_cast<double>(bars.at("rows").size());
  std::string svg = fmt::format(
      "<svg viewBox=\"0 0 {:.0f} {:.0f}\" role=\"img\" aria-label=\"{}\"><g font-size=\"12\" fill=\"#1a2230\">",
      picture_width, bottom + below, html_escaped(bars.at("title").get<std::string>()));
  for (std::size_t k = 0; k < sources.size(); ++k) {
    const double x = 12 + (picture_width - 24) / keys_in_a_line * static_cast<double>(k % keys_in_a_line);
    const double y = key_line * static_cast<double>(k / keys_in_a_line) + 4;
    svg += box(x, y, 18, 10, k) + text_at(x + 24, y + 10, "start", sources[k]);
  }
  for (double x = 0; x <= end; x += step_for(end))
    svg += upright(labels + scale * x, top, bottom, "stroke=\"#dde2e8\"") +
           text_at(labels + scale * x, bottom + 16, "middle", fmt::format("{:.3g}", x));
  double y = top;
  for (const auto& row : bars.at("rows")) {
    svg += text_at(labels - 8, y + line / 2 + 4, "end", row.at("label").get<std::string>());
    double x = labels;
    std::size_t source = 0;
    for (const double share : row.at("shares").get<std::vector<double>>()) {
      svg += box(x, y + (line - thickness) / 2, scale * share, thickness, source++);
      x += scale * share;
    }
    y += line;
  }
  return svg + upright(labels + scale, top, bottom, "stroke=\"#1a2230\" stroke-dasharray=\"4 3\"") +
         text_at((labels + picture_width - edge) / 2, bottom + 36, "middle", bars.at("x_label").get<std::string>()) +
         "</g></svg>";
}

}  // namespace fretval
