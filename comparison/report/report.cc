#include "comparison/report/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "comparison/case/case.h"
#include "comparison/quantities/quantity.h"
#include "comparison/report/drawing/figures.h"
#include "comparison/report/sections/sections.h"
#include "comparison/report/text/numbers.h"
#include "comparison/report/text/page.h"
#include "comparison/report/text/table.h"
#include "comparison/results/answer_text.h"
#include "comparison/results/results_folder.h"
#include "comparison/results/verdict_text.h"
#include "comparison/support/files.h"

namespace fretval {
namespace {

namespace fs = std::filesystem;
using Results = std::vector<StoredResult>;

/// Largest distances, over a, of what finite elements find from both of MDR's radii.
struct RadiiFindings {
  double steady_from_shakedown = 0, steady_from_first_slip = 0, never_slipped_from_first_slip = 0;
  std::string where;  // of steady_from_first_slip
  std::size_t n_cases = 0, n_without_first_slip = 0;
};

RadiiFindings radii_findings(const Results& results) {
  RadiiFindings found;
  for (const auto& r : results) {
    const double a = r.number("scene", "contact_radius_unworn");
    const double steady = r.number("fe", "stick_radius_shakedown"), never = r.number("fe", "stick_radius_first_slip");
    const double shakedown = r.number("mdr", "stick_radius_shakedown");
    const double first_slip = r.number("mdr", "stick_radius_first_slip");
    if (std::isnan(steady) || !(shakedown >= 0.1 * a)) continue;
    ++found.n_cases;
    found.steady_from_shakedown = std::max(found.steady_from_shakedown, std::abs(steady - shakedown) / a);
    if (std::isnan(first_slip)) ++found.n_without_first_slip;
    if (first_slip >= 0.1 * a && !std::isnan(never))
      found.never_slipped_from_first_slip =
          std::max(found.never_slipped_from_first_slip, std::abs(never - first_slip) / a);
    if (std::abs(steady - first_slip) / a > found.steady_from_first_slip) {
      found.steady_from_first_slip = std::abs(steady - first_slip) / a;
      found.where = r.name();
    }
  }
  return found;
}

Filling radii_section(const Results& results) {
  const auto found = radii_findings(results);
  if (found.n_cases == 0) return nullptr;
  const bool follows = found.steady_from_shakedown < found.steady_from_first_slip;
  return {{"template", "radii"},
          {"cases", counted(found.n_cases, "case")},
          {"steady_from_shakedown", number_text(found.steady_from_shakedown)},
          {"where", found.where},
          {"steady_from_first_slip", number_text(found.steady_from_first_slip, "{:.2f}")},
          {"follows", follows ? "follows" : "does not single out"},
          {"never_slipped", number_text(found.never_slipped_from_first_slip)},
          {"without_first_slip", found.n_without_first_slip == 0 ? "" : counted(found.n_without_first_slip, "case")}};
}

Filling phase_section(const Results& results) {
  const auto figures = stick_radius_figures(results);
  if (figures.empty()) return nullptr;
  return {
      {"template", "phase"}, {"radii", filling_of(figures)}, {"differences", filling_of(difference_figures(results))}};
}

/// Table of the largest differences for each rheology, which tells whether |G|/G0 is all that counts.
Filling rheology_section(const Results& results) {
  std::map<std::string, Results> by_rheology;
  for (const auto& r : results)
    if (r.swept_over("Motion / Phase") && r.has_one_frequency() && !r.has_forces())
      by_rheology[r.text("scene", "rheology")].push_back(r);
  if (by_rheology.size() < 2) return nullptr;
  Table table{{"rheology", "ρ", "cases", "first slip, largest difference", "shakedown, largest difference",
               "cycles to the steady state"}};
  for (const auto& [name, members] : by_rheology) {
    int most_cycles = 0;
    for (const auto& r : members) most_cycles = std::max(most_cycles, r.json.at("cost").value("cycles", 0));
    table.rows.push_back({name, number_text(members.front().number("mdr", "modulus_ratio"), "{:.6f}"),
                          fmt::format("{}", members.size()),
                          number_text(extreme_of(members, Quantity::stick_radius_first_slip).size),
                          number_text(extreme_of(members, Quantity::stick_radius_shakedown).size),
                          fmt::format("up to {}", most_cycles)});
  }
  return {{"template", "rheology"}, {"table", filling_of(table)}};
}

Filling limiting_section(const Results& results) {
  const auto figures = limiting_profile_figures(results);
  if (figures.empty()) return nullptr;
  Table table{{"case", "amplitude at which slip begins", "± bar", "slip inside c", "force outside c", "normal force",
               "flank touches at", "a", "a∞"}};
  for (const auto& r : results) {
    if (!r.swept_over("Wear / Stick radius ratio")) continue;
    const auto fe = [&](const char* key) { return r.number("fe", key); };
    table.rows.push_back({r.name(), fmt::format("{:.6f}", fe("limiting_amplitude")), bar_text(r, "limiting_amplitude"),
                          number_text(fe("slip_inside_stick_zone")), number_text(fe("force_outside_stick_zone")),
                          difference_text(r, "normal_force_max"), fmt::format("{:.6f} d max", fe("touch_indentation")),
                          length_text(r, "scene", "contact_radius_unworn"), length_text(r, "mdr", "worn_radius")});
  }
  return {{"template", "limiting"}, {"figures", filling_of(figures)}, {"table", filling_of(table)}};
}

/// "2 Hz, 4 Hz": the frequencies of a direction.
std::string frequencies_text(const StoredResult& r, const char* harmonics, const char* frequency) {
  const auto& scene = r.json.at("scene");
  if (!scene.contains(harmonics)) return number_text(scene.at(frequency), "{:.4g} Hz");
  std::string text;
  for (const auto& harmonic : scene.at(harmonics))
    text += (text.empty() ? "" : ", ") + number_text(harmonic.at("frequency"), "{:.4g} Hz");
  return text;
}

/// Motions that are not the paper's.
Filling motions_section(const Results& results) {
  Table table{{"case", "normal", "tangential", "a", "c first slip, MDR", "finite elements", "± bar over a",
               "c shakedown, MDR", "finite elements", "± bar over a"}};
  for (const auto& r : results) {
    if (r.has_one_frequency()) continue;
    table.rows.push_back({r.name(), frequencies_text(r, "normal_harmonics", "frequency"),
                          frequencies_text(r, "tangential_harmonics", "tangential_frequency"),
                          length_text(r, "scene", "contact_radius_unworn")});
    for (const char* key : {"stick_radius_first_slip", "stick_radius_shakedown"})
      for (const auto& cell : {length_text(r, "mdr", key), length_text(r, "fe", key), bar_text(r, key)})
        table.rows.back().push_back(cell);
  }
  if (table.rows.empty()) return nullptr;
  return {{"template", "motions"}, {"table", filling_of(table)}};
}

constexpr std::size_t few = 3, most_on_paper = 60;

/// A page of few results begins with them.
Filling cases_of_few(const Results& results) {
  return results.size() <= few ? cases_section(results) : nullptr;
}

Filling cases_of_many(const Results& results) {
  return results.size() <= few ? nullptr : cases_section(results);
}

Filling all_cases_section(const Results& results) {
  Table table{{"case", "a", "c first slip, MDR", "FE", "c shakedown, MDR", "FE", "contact radius", "normal force", ""}};
  for (const auto& r : results) {
    const auto outcome = stored_outcome(r.json);
    const auto length = [&](const char* side, const char* key) { return length_text(r, side, key); };
    table.rows.push_back({r.name(), length("scene", "contact_radius_unworn"), length("mdr", "stick_radius_first_slip"),
                          length("fe", "stick_radius_first_slip"), length("mdr", "stick_radius_shakedown"),
                          length("fe", "stick_radius_shakedown"), difference_text(r, "contact_radius_max"),
                          difference_text(r, "normal_force_max"),
                          bad_if(outcome == Outcome::disagree, name_of(outcome))});
  }
  return {{"template", "all_cases"}, {"long", results.size() > most_on_paper}, {"table", filling_of(table)}};
}

/// The title of a page without results of cases, as one of suites alone.
std::string folder_name(const fs::path& folder) {
  const auto whole = fs::weakly_canonical(folder);
  return whole.filename().empty() ? whole.string() : whole.filename().string();
}

/// The plots of sweeps come before their numbers.
Filling verdict_with_plots(const Results& results) {
  auto verdict = verdict_section(results);
  auto plots = Filling::array();
  for (const auto section : {sweeps_section, phase_section})
    if (auto filling = section(results); !filling.is_null()) plots.push_back(std::move(filling));
  verdict["plots"] = std::move(plots);
  return verdict;
}

/// Text for readers without scripts: what the terminal says about each case if they are few, and all tables.
std::string words_of(const std::string& title, const Results& results, const Filling& sections) {
  auto words = title + "\n\n";
  if (results.size() <= few)
    for (const auto& r : results) words += kept_answer_text(r.json) + "\n";
  return words + tables_text(sections);
}

using Section = Filling (*)(const Results&);
constexpr Section sections_of_results[] = {verdict_with_plots, cases_of_few,         scenes_section, radii_section,
                                           rheology_section,   motions_section,      forces_section, limiting_section,
                                           wear_section,       surface_wear_section, cases_of_many,  budget_section};
constexpr Section closing_sections[] = {cost_section, all_cases_section};

/// All sections of a page. Throws nlohmann::json::exception for a result that a section cannot read.
Filling sections_of(const fs::path& folder, const Results& results) {
  auto sections = Filling::array();
  const auto add = [&](Filling section) {
    if (!section.is_null()) sections.push_back(std::move(section));
  };
  add(section_of(folder / "trust.json", trust_section));
  if (!results.empty())
    for (const auto section : sections_of_results) add(section(results));
  add(trade_section(folder));
  for (const char* suite : {"tolerance.json", "extremes.json", "random.json"})
    add(section_of(folder / suite, suite_section));
  add(section_of(folder / "exact.json", convergence_section));
  if (!results.empty())
    for (const auto section : closing_sections) add(section(results));
  return sections;
}

fs::path write_page(const fs::path& folder, const Results& results, const std::set<std::string>& of_this_run) {
  auto sections = sections_of(folder, results);
  if (sections.empty())
    throw InputError(
        fmt::format("{}: there is no result.json, trade.json, trust.json or JSON of a suite below it; expected a "
                    "folder that fretval run, trade, trust or check --json has written",
                    folder.string()));
  fs::path file = folder / "index.html";
  auto heading = heading_of(results, of_this_run, folder_name(folder));
  const auto title = heading.at("title").get<std::string>();
  const auto words = words_of(title, results, sections);
  write_file(
      file, page_of(title + " · fretval", words, {{"heading", std::move(heading)}, {"sections", std::move(sections)}}));
  write_sweeps(results);
  return file;
}

/// Of results that a section cannot read, the file of the first that alone is not read either; or their folder.
fs::path unreadable_of(const fs::path& folder, const Results& results) {
  for (const auto& result : results) {
    try {
      const Results alone{result};
      words_of("", alone, sections_of(result.folder, alone));
    } catch (const nlohmann::json::exception&) {
      return result.folder / "result.json";
    }
  }
  return folder;
}

}  // namespace

fs::path write_report(const fs::path& folder, const std::set<std::string>& of_this_run) {
  const auto results = read_results(folder);
  try {
    return write_page(folder, results, of_this_run);
  } catch (const nlohmann::json::exception& error) {
    throw InputError(
        fmt::format("{}: {}; is this a result of fretval?", unreadable_of(folder, results).string(), error.what()));
  }
}

}  // namespace fretval
