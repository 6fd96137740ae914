#include "comparison/report/sketch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparison/results/answer_text.h"

namespace fretval {
namespace {

constexpr double drawing_width = 960, middle = drawing_width / 2, margin_above = 64, margin_below = 96;

/// From the scale of a drawing to its pixels; depth counts downwards from the surface at rest.
struct Paper {
  double pixels_per_metre, surface;
  [[nodiscard]] std::string point(double r, double depth) const {
    return fmt::format("{:.1f},{:.1f} ", middle + r * pixels_per_metre, surface + depth * pixels_per_metre);
  }
};

using Curve = std::pair<std::vector<double>, std::vector<double>>;

/// Both halves of a curve of heights above the tip, from the left to the right.
std::string both_halves(const Paper& paper, const Curve& curve, double tip) {
  std::string points;
  const auto& [r, height] = curve;
  for (std::size_t i = r.size(); i-- > 0;) points += paper.point(-r[i], tip - height[i]);
  for (std::size_t i = 0; i < r.size(); ++i) points += paper.point(r[i], tip - height[i]);
  return points;
}

double largest_indentation(const StoredResult& r) {
  const double compared = r.number("fe", "indentation_max"), stored = r.number("scene", "indentation_max");
  if (std::isfinite(compared)) return compared;
  if (std::isfinite(stored)) return stored;
  return r.number("scene", "indentation") + r.number("scene", "normal_amplitude");
}

std::string with_three_digits(double value, const char* unit) {
  const auto [prefix, factor] = prefix_for(value);
  return fmt::format("{:.3g} {}{}", value / factor, prefix, unit);
}

}  // namespace

Filling sketch_of(const StoredResult& result) {
  const auto profile = read_columns(result.folder / "profile.csv", "r [m]", "f unworn [m]");
  auto surface = read_columns(result.folder / "contact.csv", "r outer [m]", "surface height at d max [m]");
  const double a = result.number("scene", "contact_radius_unworn"), tip = largest_indentation(result);
  const double c = result.number("fe", "stick_radius_shakedown");
  const double u = std::isfinite(result.number("scene", "tangential_amplitude"))
                       ? result.number("scene", "tangential_amplitude")
                       : result.number("fe", "tangential_amplitude");
  if (profile.first.size() < 2 || surface.first.empty() || !(a > 0) || !(tip > 0)) return nullptr;
  const double end = profile.first.back(), rise = std::max(profile.second.back() - tip, 0.1 * a);
  const double scale = std::min(0.5 * (drawing_width - 40) / (1.15 * end), 260 / (rise + tip));
  const Paper paper{scale, margin_above + rise * scale};
  const double bottom = paper.surface + tip * scale;
  const auto x = [&](double r) { return fmt::format("{:.1f}", middle + r * scale); };
  Filling filling{{"template", "sketch"},
                  {"width", drawing_width},
                  {"height", fmt::format("{:.0f}", bottom + margin_below)},
                  {"indenter", both_halves(paper, profile, tip)},
                  {"surface", both_halves(paper, surface, tip)},
                  {"level", fmt::format("{:.1f}", paper.surface)},
                  {"bottom", fmt::format("{:.1f}", bottom)},
                  {"middle", middle},
                  {"a_line", fmt::format("{:.1f}", bottom + 62)},
                  {"a_text", fmt::format("{:.1f}", bottom + 80)},
                  {"c_line", fmt::format("{:.1f}", bottom + 24)},
                  {"c_text", fmt::format("{:.1f}", bottom + 42)},
                  {"a_left", x(-a)},
                  {"a_right", x(a)},
                  {"a", with_three_digits(a, "m")},
                  {"d", with_three_digits(tip, "m")}};
  if (c > 0) filling["stick"] = {{"left", x(-c)}, {"right", x(c)}, {"c", with_three_digits(c, "m")}};
  if (u > 0)
    filling["slide"] = {{"left", fmt::format("{:.1f}", middle - std::max(u * scale, 14.0))},
                        {"right", fmt::format("{:.1f}", middle + std::max(u * scale, 14.0))},
                        {"u", with_three_digits(u, "m")}};
  return filling;
}

}  // namespace fretval
