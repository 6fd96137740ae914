#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparison/report/drawing/figures.h"
#include "comparison/results/answer_text.h"

namespace fretval {
namespace {

constexpr double drawing_width = 960, middle = drawing_width / 2, margin_above = 150, margin_below = 110;

// Places of the motions over time, above either side of the indenter.
constexpr double motion_width = 250, motion_height = 62, motion_top = 40, motion_edge = 20;

/// Scale of a drawing in pixels; depth counts downwards from the surface at rest.
struct Paper {
  double pixels_per_metre, surface;
  [[nodiscard]] std::string point(double r, double depth) const {
    return fmt::format("{:.1f},{:.1f} ", middle + r * pixels_per_metre, surface + depth * pixels_per_metre);
  }
};

using Curve = std::pair<std::vector<double>, std::vector<double>>;

/// Points of a curve of heights above the tip and of its mirror image, from the left to the right.
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

/// "80 to 120 µm"
std::string range_text(double least, double most) {
  const auto [prefix, factor] = prefix_for(std::max(std::abs(least), std::abs(most)));
  return fmt::format("{:.3g} to {:.3g} {}m", least / factor, most / factor, prefix);
}

/// Values up to the one at which so many swings are over, from the lower quarter of the range to the upper one or back;
/// all, if there are not twice as many: of an unlocked phase the last period has dozens, too many to be drawn so small.
std::size_t n_of_first_swings(const std::vector<double>& value) {
  constexpr int n_swings = 12;
  if (value.empty()) return 0;
  const auto [least, most] = std::minmax_element(value.begin(), value.end());
  const double quarter = (*most - *least) / 4;
  int n = 0, side = 0;
  std::size_t n_shown = value.size();
  for (std::size_t i = 0; i < value.size(); ++i) {
    const int now = value[i] > *most - quarter ? 1 : value[i] < *least + quarter ? -1 : side;
    if (now != side && side != 0 && ++n == n_swings) n_shown = i;
    side = now;
  }
  return n < 2 * n_swings ? value.size() : n_shown;
}

/// A displacement over the first rows of the last period, in a box of its own; null for one that does not change.
Filling motion_of(const StoredResult& r, const char* name, const char* column, std::size_t n_shown, double left) {
  auto [time, value] = read_columns(r.folder / "history.csv", "t [s]", column);
  if (value.size() < 2) return nullptr;
  const auto [first, last] = std::minmax_element(value.begin(), value.end());
  const double least = *first, most = *last;
  if (!(most > least)) return nullptr;
  const bool all = n_shown >= value.size();
  if (!all) {
    time.resize(n_shown);
    value.resize(n_shown);
  }
  std::string points;
  const auto stride = 1 + value.size() / 120;
  for (std::size_t i = 0; i < value.size(); i += stride)
    points +=
        fmt::format("{:.1f},{:.1f} ", left + motion_width * (time[i] - time.front()) / (time.back() - time.front()),
                    motion_top + motion_height * (most - value[i]) / (most - least));
  return {{"points", points},
          {"left", left},
          {"right", left + motion_width},
          {"bottom", motion_top + motion_height + 8},
          {"title_at", motion_top - 14},
          {"title", fmt::format("{} = {}{}", name, range_text(least, most), all ? "" : ", first cycles")}};
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
                  {"a_line", fmt::format("{:.1f}", bottom + 70)},
                  {"a_text", fmt::format("{:.1f}", bottom + 96)},
                  {"c_line", fmt::format("{:.1f}", bottom + 24)},
                  {"c_text", fmt::format("{:.1f}", bottom + 50)},
                  {"a_left", x(-a)},
                  {"a_right", x(a)},
                  {"a", with_prefix(a, "m")},
                  {"d", with_prefix(tip, "m")}};
  if (c > 0) filling["stick"] = {{"left", x(-c)}, {"right", x(c)}, {"c", with_prefix(c, "m")}};
  filling["motions"] = Filling::array();
  const auto history = result.folder / "history.csv";
  const auto n_shown = std::min(n_of_first_swings(read_columns(history, "t [s]", "d [m]").second),
                                n_of_first_swings(read_columns(history, "t [s]", "u_x [m]").second));
  for (auto motion : {motion_of(result, "d(t)", "d [m]", n_shown, motion_edge),
                      motion_of(result, "uₓ(t)", "u_x [m]", n_shown, drawing_width - motion_edge - motion_width)})
    if (!motion.is_null()) filling["motions"].push_back(std::move(motion));
  if (u > 0)
    filling["slide"] = {{"left", fmt::format("{:.1f}", middle - std::max(u * scale, 14.0))},
                        {"right", fmt::format("{:.1f}", middle + std::max(u * scale, 14.0))},
                        {"u", with_prefix(u, "m")}};
  return filling;
}

}  // namespace fretval
