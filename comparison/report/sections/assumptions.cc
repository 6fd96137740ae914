#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "comparison/quantities/quantity.h"
#include "comparison/report/sections/sections.h"
#include "comparison/report/text/numbers.h"
#include "comparison/results/answer_text.h"
#include "comparison/support/constants.h"
#include "comparison/support/json.h"

namespace fretval {
namespace {

using nlohmann::ordered_json;

/// Coefficient of the first term by which the force of a sphere on an incompressible bonded layer exceeds that on a
/// half-space, relative, over a/h (Dimitriadis, Horkay, Maresca, Kachar, Chadwick, Biophysical Journal 82 (2002) 2798).
constexpr double bonded_layer = 1.133;
constexpr double share_of_the_base = 0.01;

/// Where the finite elements end, over the largest contact radius; NaN if the folder does not say.
double far_radius_of(const StoredResult& r) {
  std::ifstream stream(r.folder / "run.json");
  if (!stream) return std::nan("");
  const auto run = ordered_json::parse(stream, nullptr, false);
  return run.is_object() ? number_or_nan(run.value("resolution", ordered_json()), "far_radius") : std::nan("");
}

/// What the far boundary adds to the error bars, of the quantity where that is most of its tolerance.
void add_far_boundary(const StoredResult& r, Filling& filling) {
  double most = -1;
  std::string where;
  const auto bars = r.json.at("fe").value("error_estimate", ordered_json::object());
  for (const auto& [key, bar] : bars.items()) {
    const auto quantity = quantity_of(key);
    const auto compared = r.json.at("comparison").find(key);
    if (!quantity || !bar.is_object() || compared == r.json.at("comparison").end()) continue;
    const auto share = bar.value("shares", ordered_json::object()).value("far field", ordered_json::object());
    const auto estimate = number_in(share, "estimate");
    const double of_tolerance = estimate.value_or(0) / compared->at("tolerance").get<double>();
    if (!estimate || of_tolerance <= most) continue;
    most = of_tolerance;
    where = traits_of(*quantity).title;
  }
  if (most < 0) return;
  filling["far_share"] = fmt::format("{:.2g}", 100 * most);
  filling["far_quantity"] = where;
  if (const double radius = far_radius_of(r); std::isfinite(radius))
    filling["far_radius"] = fmt::format("{:g}", radius);
}

}  // namespace

Filling assumptions_of(const StoredResult& r) {
  Filling filling{{"template", "assumptions"}};
  const auto& scene = r.json.at("scene");
  const double a = r.number("scene", "contact_radius_unworn");
  const auto add = [&](const char* key, double value, const char* format) {
    if (std::isfinite(value)) filling[key] = number_text(value, format);
  };
  if (r.text("scene", "shape") == "parabola")
    add("arc", 100 * std::pow(a / input_number(r, "Radius"), 2) / 4, "{:.2g}");
  if (!scene.contains("path"))
    add("lift_off", r.number("scene", "normal_amplitude") / r.number("scene", "indentation"), "{:.3g}");
  const auto [x, f] = read_columns(r.folder / "profile.csv", "r [m]", "f unworn [m]");
  const auto at = std::lower_bound(x.begin(), x.end(), a) - x.begin();
  if (at > 0 && at < static_cast<std::ptrdiff_t>(x.size())) {
    const auto i = static_cast<std::size_t>(at);
    add("slope", std::atan((f[i] - f[i - 1]) / (x[i] - x[i - 1])) * 180 / pi, "{:.2g}");
  }
  const bool half_space = std::isnan(input_number(r, "Thickness")) && !scene.contains("mesh"),
             compressible = !std::isnan(input_number(r, "Poisson ratio"));
  const bool is_vector = input_word(r, "Friction") == "vector", coupled = input_word(r, "Coupling") == "on";
  if ((!half_space || compressible) && !coupled) filling["uncoupled"] = true;
  filling[is_vector ? "vector" : "unidirectional"] = true;
  if (a > 0 && half_space) {
    filling["depth"] = with_prefix(bonded_layer / share_of_the_base * a, "m");
    filling["depth_over_a"] = fmt::format("{:.0f}", bonded_layer / share_of_the_base);
  }
  add_far_boundary(r, filling);
  return filling;
}

}  // namespace fretval
