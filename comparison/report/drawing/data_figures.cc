#include <fmt/format.h>

#include <cmath>

#include "comparison/report/drawing/figures.h"
#include "comparison/report/drawing/plots.h"

namespace fretval {
namespace {

using Numbers = std::vector<double>;
using nlohmann::ordered_json;

constexpr int colour_of_measured = 2;

Figure recorded_figure(const StoredResult& r, const nlohmann::ordered_json& trace) {
  const auto [x, z] = read_columns(r.folder / "trace.csv", "x [m]", "z [m]");
  const auto length = axis_for({&x}, "m"), height = axis_for({&z}, "m");
  Plot plot{"The trace as it was recorded", "x in " + length.unit, "z in " + height.unit};
  plot.series.push_back({"trace", length.of(x), height.of(z), Series::Style::points, colour_of_measured});
  plot.marks.emplace_back("apex", trace.at("apex").get<double>() / length.factor);
  return {
      std::move(plot),
      fmt::format("Heights {}. The fit of an even course and a tilt puts the apex at {:.4g} ± {:.2g} {} and the tilt "
                  "of the stage at {:.3g} ± {:.1g}°; what that leaves open of the answer is in its error bars.",
                  trace.at("heights").get<std::string>(), trace.at("apex").get<double>() / length.factor,
                  trace.at("apex_uncertainty").get<double>() / length.factor, length.unit,
                  trace.at("tilt").get<double>(), trace.at("tilt_uncertainty").get<double>())};
}

Figure aligned_figure(const StoredResult& r) {
  const auto [radius, f] = read_columns(r.folder / "aligned_profile.csv", "r [m]", "f [m]");
  const auto [fitted_r, fitted] = read_columns(r.folder / "profile.csv", "r [m]", "f unworn [m]");
  const auto length = axis_for({&radius}, "m"), height = axis_for({&f}, "m");
  Plot plot{"The aligned profile", "r in " + length.unit, "f in " + height.unit};
  plot.series = {{"both halves", length.of(radius), height.of(f), Series::Style::points, colour_of_measured},
                 {"profile that is computed with", length.of(fitted_r), height.of(fitted), Series::Style::line, 0}};
  plot.marks = radius_marks(r, length);
  return {std::move(plot),
          "Heights of both halves over the distance from the apex, without the tilt, and the convex profile through "
          "them, which is the input of both methods."};
}

Figure residual_figure(const StoredResult& r, const nlohmann::ordered_json& trace) {
  const auto [x, residual] = read_columns(r.folder / "trace.csv", "x [m]", "residual [m]");
  Numbers at, left;
  for (std::size_t i = 0; i < residual.size(); ++i) {
    if (std::isnan(residual[i])) continue;
    at.push_back(x[i]);
    left.push_back(residual[i]);
  }
  const auto length = axis_for({&at}, "m"), height = axis_for({&left}, "m");
  Plot plot{"What is left of the trace", "x in " + length.unit, "residual in " + height.unit};
  plot.series.push_back({"residual", length.of(at), height.of(left), Series::Style::points, colour_of_measured});
  return {std::move(plot), fmt::format("Trace less aligned profile and tilt. Noise: {:.3g} {}, standard deviation; a "
                                       "course that is left over would be no axisymmetric body.",
                                       trace.at("noise").get<double>() / height.factor, height.unit)};
}

std::string fit_text(const ordered_json& fit) {
  const auto percent = [](const ordered_json& share) { return 100 * share.get<double>(); };
  auto text = fmt::format(
      " Both methods compute with the Prony body (lines), not with the table (points): it misses the moduli by {:.2g} "
      "%, root mean square, most at {:.3g} Hz by {:.2g} %.",
      percent(fit.at("residual")), fit.at("worst_frequency").get<double>(), percent(fit.at("worst")));
  const auto& check = fit.at("kramers_kronig");
  if (check.is_null()) return text + " The table is too sparse to hold G' and G'' to each other (Kramers and Kronig).";
  return text + (check.at("consistent").get<bool>()
                     ? " The measured G' and G'' belong to one linear body (Kramers and Kronig)."
                     : " The measured G' and G'' contradict each other (Kramers and Kronig).");
}

}  // namespace

std::vector<Figure> trace_figures(const StoredResult& r) {
  const auto& scene = r.json.at("scene");
  if (!scene.contains("data") || !scene["data"].contains("trace")) return {};
  if (column_names(r.folder / "trace.csv").empty()) return {};
  const auto& trace = scene["data"]["trace"];
  return {recorded_figure(r, trace), aligned_figure(r), residual_figure(r, trace)};
}

std::vector<Series> measured_series(const StoredResult& r, const std::string& x, const std::string& y, double x_factor,
                                    double y_factor) {
  auto [at, values] = read_columns(r.folder / "measured_loops.csv", x, y);
  if (at.empty()) return {};
  const double start = x == "t [s]" ? at.front() : 0;
  for (double& one : at) one = (one - start) / x_factor;
  for (double& one : values) one /= y_factor;
  return {{"measured", std::move(at), std::move(values), Series::Style::open_points, colour_of_measured}};
}

Figure moduli_figure(const StoredResult& r) {
  const auto [f, storage] = read_columns(r.folder / "moduli.csv", "f [Hz]", "G' [Pa]");
  const auto loss = read_columns(r.folder / "moduli.csv", "f [Hz]", "G'' [Pa]").second;
  const auto modulus = axis_for({&storage, &loss}, "Pa");
  Plot plot{"The elastomer", "frequency in Hz", "modulus in " + modulus.unit};
  plot.log_x = plot.log_y = true;
  plot.series = {{"storage modulus G'", f, modulus.of(storage), Series::Style::line, 0},
                 {"loss modulus G''", f, modulus.of(loss), Series::Style::line, 1}};
  std::string caption = "Moduli of the body. It is an input of both methods.";
  if (const auto measured = r.folder / "measured_moduli.csv"; !column_names(measured).empty()) {
    const auto at = read_columns(measured, "f [Hz]", "f [Hz]").first;
    for (const auto& [name, colour] : {std::pair{"G' [Pa]", 0}, std::pair{"G'' [Pa]", 1}})
      plot.series.push_back({colour == 0 ? "G' measured" : "G'' measured", at,
                             modulus.of(read_columns(measured, "f [Hz]", name).second), Series::Style::points, colour});
    if (const auto fit = r.json.at("scene").find("fit_of_moduli"); fit != r.json.at("scene").end())
      caption += fit_text(*fit);
  }
  const double normal = r.number("scene", "frequency"), tangential = r.number("scene", "tangential_frequency");
  if (normal > 0) plot.marks.emplace_back(normal == tangential ? "motion" : "normal", normal);
  if (tangential > 0 && tangential != normal) plot.marks.emplace_back("tangential", tangential);
  return {std::move(plot), caption};
}

}  // namespace fretval
