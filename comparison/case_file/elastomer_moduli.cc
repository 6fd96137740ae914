#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <utility>

#include "comparison/case_file/case_sections.h"
#include "comparison/data/branches_file.h"

namespace fretval {
namespace {

/// The modulus of a series whose ratios the case has, or whose file does not say it; empty: the relaxed one is known.
std::optional<double> read_instantaneous(const EntryReader& entries) {
  const std::string section = "Elastomer", name = "Instantaneous shear modulus";
  if (!entries.given(section, name)) return std::nullopt;
  entries.forbid(section, "Relaxed shear modulus", "the Instantaneous shear modulus and the branches tell it");
  return entries.number(section, name);
}

void take_series(const EntryReader& entries, const std::string& source, PronySeries series,
                 Case::Elastomer& elastomer) {
  try {
    if (const auto instantaneous = read_instantaneous(entries)) {
      if (series.instantaneous)
        throw InputError(source + ": has the instantaneous modulus, which the case has as well; must be given once");
      series.instantaneous = instantaneous;
    }
    take_prony_series(source, series, elastomer);
  } catch (const InputError& error) {
    entries.add_problem(error.what());
  }
}

void read_branches_from_file(const EntryReader& entries, Case::Elastomer& elastomer, std::vector<std::string>& notes) {
  const std::string section = "Elastomer";
  entries.forbid_all(section, {"Branch moduli", "Branch times", "Branch ratios"}, "the file of Branches has them");
  const auto file = entries.path(section, "Branches");
  if (file.empty()) return;
  std::optional<bool> youngs;
  if (entries.given(section, "Table modulus")) youngs = entries.word(section, "Table modulus") == "Young";
  try {
    auto series = read_prony_series(file, elastomer.poisson_ratio, youngs);
    if (!series.notes.empty()) notes.push_back(series.notes);
    take_series(entries, file, std::move(series), elastomer);
  } catch (const InputError& error) {
    entries.add_problem(error.what());
  }
}

void read_branch_ratios(const EntryReader& entries, Case::Elastomer& elastomer) {
  const std::string section = "Elastomer";
  entries.forbid(section, "Branch moduli", "the Branch ratios stand in their place");
  PronySeries series;
  series.ratios = entries.numbers(section, "Branch ratios");
  series.times = entries.numbers(section, "Branch times");
  if (series.ratios.empty() || series.times.empty()) return;
  double sum = 0;
  for (const double ratio : series.ratios) sum += ratio;
  if (sum >= 1) return entries.fail(section, "Branch ratios", "ratios to the instantaneous modulus of a sum below 1");
  if (series.ratios.size() != series.times.size())
    return entries.fail(section, "Branch times",
                        fmt::format("{} times, one for each of the Branch ratios", series.ratios.size()));
  take_series(entries, entries.file(), std::move(series), elastomer);
  elastomer.branches_file.clear();
}

/// Gent 1958: of a punch into an incompressible body, whose Young's modulus is 0.0981 (56 + 7.62336 S) /
/// (0.137505 (254 - 2.54 S)) MPa.
void take_shore_hardness(const EntryReader& entries, Case::Elastomer& elastomer, std::vector<std::string>& notes) {
  const std::string section = "Elastomer", name = "Shore A";
  entries.forbid(section, "Relaxed shear modulus", "the hardness Shore A tells it");
  const double hardness = entries.number(section, name);
  if (std::isnan(hardness)) return;
  constexpr double scatter = 0.2;
  const double youngs = 1e6 * 0.0981 * (56 + 7.62336 * hardness) / (0.137505 * (254 - 2.54 * hardness));
  elastomer.relaxed_modulus = youngs / 3;
  elastomer.shore_a = hardness;
  elastomer.modulus_scatter = scatter;
  notes.push_back(
      fmt::format("{}: Elastomer / Shore A = {:g}: G = {:.3g} Pa by Gent's formula, from which rubbers scatter by some "
                  "{:.0f} %, forces with it; radii under prescribed displacements do not depend on it",
                  entries.file(), hardness, elastomer.relaxed_modulus, 100 * scatter));
}

}  // namespace

void read_relaxed_modulus(const EntryReader& entries, Case::Elastomer& elastomer, std::vector<std::string>& notes) {
  const std::string section = "Elastomer", name = "Relaxed shear modulus";
  if (entries.given(section, "Shore A")) return take_shore_hardness(entries, elastomer, notes);
  const bool is_told_by_series = entries.given(section, "Branches") || entries.given(section, "Branch ratios");
  if (is_told_by_series && !entries.given(section, name)) return;
  elastomer.relaxed_modulus = entries.number(section, name);
}

void read_branches(const EntryReader& entries, Case::Elastomer& elastomer, std::vector<std::string>& notes) {
  const std::string section = "Elastomer";
  if (entries.given(section, "Branches")) return read_branches_from_file(entries, elastomer, notes);
  if (entries.given(section, "Branch ratios")) return read_branch_ratios(entries, elastomer);
  elastomer.branch_moduli = entries.numbers(section, "Branch moduli");
  elastomer.branch_times = entries.numbers(section, "Branch times");
  const auto n = elastomer.branch_moduli.size();
  if (n == 0) return;
  if (elastomer.rheology != Case::Rheology::prony && n != 1)
    entries.fail(section, "Branch moduli", "one modulus; use Rheology = prony for several branches");
  if (!elastomer.branch_times.empty() && elastomer.branch_times.size() != n)
    entries.fail(section, "Branch times", fmt::format("{} times, one for each of the Branch moduli", n));
}

}  // namespace fretval
