#include "comparison/data/master_curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "comparison/data/table_units.h"
#include "comparison/support/constants.h"
#include "mdr/rheology/kramers_kronig.h"
#include "mdr/rheology/modulus_table.h"
#include "mdr/rheology/prony_fit.h"

namespace fretval {
namespace {

// Good measurements of one sample fit to a few percent.
constexpr double bad_residual = 0.1;
constexpr double far_below_measured = 0.7;
constexpr double still_relaxing = 0.1;  // tan delta: G' falls by some 15 % in a decade

void warn(const std::string& file, const mdr::ModulusTable& table, const mdr::PronyFit& fit,
          const std::optional<mdr::KramersKronig>& relation, std::vector<std::string>& warnings) {
  if (!relation)
    warnings.push_back(fmt::format("{}: G' and G'' are not held to each other (Kramers and Kronig): {}", file,
                                   mdr::too_sparse_for_kramers_kronig(table)));
  if (relation && !relation->consistent)
    warnings.push_back(
        fmt::format("{}: G' and G'' contradict each other (Kramers and Kronig), most at {:.3g} Hz by {:.0f} %; no "
                    "linear viscoelastic body has these moduli, so the bars have what a body that is fitted to G' "
                    "alone would change; shift the isotherms by G' and G'' alike, or leave out the rows",
                    file, relation->frequency_at_worst, 100 * relation->worst));
  if (fit.residual > bad_residual)
    warnings.push_back(
        fmt::format("{}: the Prony body misses the moduli by {:.0f} % (root mean square), most at "
                    "{:.3g} Hz by {:.0f} %",
                    file, 100 * fit.residual, fit.worst_frequency, 100 * fit.worst));
  const double lowest = *std::min_element(table.storage.begin(), table.storage.end());
  const bool is_told = table.loss.front() > still_relaxing * table.storage.front();
  if (!is_told && fit.body.relaxed_modulus < far_below_measured * lowest)
    warnings.push_back(
        fmt::format("{}: the relaxed modulus of the fit, {:.3g} Pa, is far below the lowest measured "
                    "G', {:.3g} Pa: the table does not reach the plateau, on which |G|/G'(0) depends",
                    file, fit.body.relaxed_modulus, lowest));
}

/// Slope of ln G'' over ln f between the lowest frequencies, a decade or three of them.
double slope_of_loss(const Case::MasterCurve& data) {
  constexpr double decade = 10;
  std::size_t last = std::min<std::size_t>(2, data.frequency.size() - 1);
  while (last + 1 < data.frequency.size() && data.frequency[last] < decade * data.frequency.front()) ++last;
  return std::log(data.loss[last] / data.loss.front()) / std::log(data.frequency[last] / data.frequency.front());
}

}  // namespace

std::optional<RelaxedModulusRange> extrapolated_range(const Case::MasterCurve& data, double fitted) {
  const auto lowest = std::min_element(data.frequency.begin(), data.frequency.end()) - data.frequency.begin();
  if (lowest != 0 || data.frequency.size() < 2) return std::nullopt;
  const double storage = data.storage.front(), loss = data.loss.front();
  if (!(loss > still_relaxing * storage)) return std::nullopt;
  const double slope = std::min(1.0, slope_of_loss(data));
  const double below = slope > 0 ? std::max(0.0, storage - 2 / pi * loss / slope) : 0;
  return RelaxedModulusRange{std::min(below, fitted), std::max(storage, fitted)};
}

void fit_master_curve(const std::string& file, bool youngs, Case::Elastomer& elastomer,
                      std::vector<std::string>& warnings) {
  input_from(file, [&] {
    std::ifstream stream(file);
    const auto table = mdr::read_modulus_table(stream, file, youngs ? 1 / (2 * (1 + elastomer.poisson_ratio)) : 1);
    const auto fit = mdr::fit_prony(table);
    const auto relation =
        mdr::too_sparse_for_kramers_kronig(table).empty() ? std::optional(mdr::kramers_kronig(table)) : std::nullopt;
    elastomer.relaxed_modulus = fit.body.relaxed_modulus;
    elastomer.branch_moduli = fit.body.branch_moduli;
    elastomer.branch_times = fit.body.branch_times;
    elastomer.viscosity = fit.body.viscosity;
    elastomer.master_curve =
        Case::MasterCurve{file,         table.frequency, table.storage,       table.loss, fit.residual,
                          fit.held_out, fit.worst,       fit.worst_frequency, relation,   youngs};
    warn(file, table, fit, relation, warnings);
    if (const auto range = extrapolated_range(*elastomer.master_curve, elastomer.relaxed_modulus))
      warnings.push_back(fmt::format(
          "{}: at the lowest frequency, {:.3g} Hz, tan delta is still {:.2g}: the relaxed modulus G'(0) is "
          "extrapolated, to {:.2g} Pa, and may be {:.2g} to {:.2g} Pa; measure down to lower frequencies, or set "
          "Elastomer / Duration of the test to how long the test lasts",
          file, table.frequency.front(), table.loss.front() / table.storage.front(), elastomer.relaxed_modulus,
          range->least, range->most));
  });
}

}  // namespace fretval
