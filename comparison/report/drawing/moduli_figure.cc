#include "comparison/report/drawing/moduli_figure.h"

#include <fmt/format.h>

#include "comparison/report/drawing/axis.h"

namespace fretval {
namespace {

using nlohmann::ordered_json;

std::string fit_text(const ordered_json& fit) {
  const auto percent = [](const ordered_json& share) { return 100 * share.get<double>(); };
  auto text = fmt::format(
      " Both methods compute with the Prony body (lines), not with the table (points): it misses the moduli by {:.2g} "
      "%, "
      "root mean square, most at {:.3g} Hz by {:.2g} %.",
      percent(fit.at("residual")), fit.at("worst_frequency").get<double>(), percent(fit.at("worst")));
  const auto& check = fit.at("kramers_kronig");
  if (check.is_null()) return text + " The table is too sparse to hold G' and G'' to each other (Kramers and Kronig).";
  return text + (check.at("consistent").get<bool>()
                     ? " The measured G' and G'' belong to one linear body (Kramers and Kronig)."
                     : " The measured G' and G'' contradict each other (Kramers and Kronig).");
}

}  // namespace

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
