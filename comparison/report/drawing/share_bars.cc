#include "comparison/report/drawing/share_bars.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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
                   const std::vector<ShareRow>& rows, double limit, const std::string& of_what) {
  Filling bars{{"kind", "bars"},     {"title", title}, {"x_label", label},        {"sources", sources},
               {"of_what", of_what}, {"limit", limit}, {"rows", Filling::array()}};
  for (const auto& [name, shares, start, bar] : rows)
    bars["rows"].push_back({{"label", name}, {"shares", shares}, {"start", start}, {"bar", bar}});
  return bars;
}

std::string share_bars_svg(const Filling& bars) {
  const auto sources = bars.at("sources").get<std::vector<std::string>>();
  const double limit = bars.at("limit").get<double>();
  double longest = limit, lowest = 0;
  for (const auto& row : bars.at("rows")) {
    double at = row.at("start").get<double>();
    const double bar = row.at("bar").get<double>();
    for (const double share : row.at("shares").get<std::vector<double>>()) {
      at += share;
      longest = std::max({longest, at - share, at});
      lowest = std::min({lowest, at - share, at});
    }
    longest = std::max(longest, at + bar);
    lowest = std::min(lowest, at - bar);
  }
  const double begin = beyond_the_longest * lowest, end = beyond_the_longest * longest;
  const double scale = (picture_width - labels - edge) / (end - begin);
  const auto place = [&](double value) { return labels + scale * (value - begin); };
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
  const double step = step_for(end - begin);
  for (double n = std::ceil(begin / step); n * step <= end; ++n)
    svg += upright(place(n * step), top, bottom, "stroke=\"#dde2e8\"") +
           text_at(place(n * step), bottom + 16, "middle", fmt::format("{:.3g}", n * step));
  double y = top;
  for (const auto& row : bars.at("rows")) {
    svg += text_at(labels - 8, y + line / 2 + 4, "end", row.at("label").get<std::string>());
    double at = row.at("start").get<double>();
    std::size_t source = 0;
    for (const double share : row.at("shares").get<std::vector<double>>()) {
      svg += box(place(std::min(at, at + share)), y + (line - thickness) / 2, scale * std::abs(share), thickness,
                 source++);
      at += share;
    }
    if (const double bar = row.at("bar").get<double>(); bar > 0)
      svg += fmt::format(
          "<line x1=\"{0:.2f}\" x2=\"{1:.2f}\" y1=\"{2:.1f}\" y2=\"{2:.1f}\" stroke=\"#1a2230\" stroke-width=\"2\"/>",
          place(at - bar), place(at + bar), y + line / 2);
    y += line;
  }
  return svg + upright(place(limit), top, bottom, "stroke=\"#1a2230\" stroke-dasharray=\"4 3\"") +
         text_at((labels + picture_width - edge) / 2, bottom + 36, "middle", bars.at("x_label").get<std::string>()) +
         "</g></svg>";
}

}  // namespace fretval
