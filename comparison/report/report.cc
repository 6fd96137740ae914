#include "comparison/report/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "comparison/accuracy/quantity.h"
#include "comparison/case/case.h"
#include "comparison/report/exact_section.h"
#include "comparison/report/figures.h"
#include "comparison/report/forces_section.h"
#include "comparison/report/suite_section.h"
#include "comparison/report/table.h"
#include "comparison/report/trade_section.h"
#include "comparison/report/verdict_section.h"
#include "comparison/report/wear_section.h"
#include "comparison/results/results_folder.h"
#include "comparison/support/escape.h"
#include "comparison/support/files.h"
#include "comparison/support/versions.h"

namespace fretval {
namespace {

namespace fs = std::filesystem;
using Results = std::vector<StoredResult>;

constexpr const char* style = R"(
:root { color-scheme: light; --ink: #1d2430; --soft: #5b6573; --line: #dfe3e8; --good: #0b7a4b; --bad: #b3261e; }
body { font: 16px/1.55 system-ui, "Helvetica Neue", Arial, sans-serif; color: var(--ink); background: #fff;
       max-width: 1180px; margin: 2.5rem auto; padding: 0 1.25rem; }
h1 { font-size: 1.9rem; margin: 0 0 .3rem; } h2 { font-size: 1.3rem; margin: 2.6rem 0 .6rem; }
p { max-width: 52rem; } .lead { font-size: 1.1rem; } .soft { color: var(--soft); }
.badge { display: inline-block; padding: .1rem .6rem; border-radius: 1rem; color: #fff; font-weight: 600; }
.good { background: var(--good); } .bad { background: var(--bad); }
.tiles { display: grid; grid-template-columns: repeat(auto-fit, minmax(13rem, 1fr)); gap: 1rem; margin: 1.5rem 0; }
.tile { border: 1px solid var(--line); border-radius: .6rem; padding: .8rem 1rem; }
.tile b { display: block; font-size: 1.45rem; }
.figures { display: grid; grid-template-columns: repeat(auto-fill, minmax(30rem, 1fr)); gap: 1.2rem; }
figure { margin: 0; border: 1px solid var(--line); border-radius: .6rem; padding: .6rem; }
figure svg { width: 100%; height: auto; } figcaption { font-size: .88rem; color: var(--soft); padding: 0 .4rem .3rem; }
table { border-collapse: collapse; font-size: .9rem; font-variant-numeric: tabular-nums; }
th, td { text-align: right; padding: .25rem .7rem; border-bottom: 1px solid var(--line); }
td { white-space: nowrap; } td:first-child, td.words { white-space: normal; }
th:first-child, td:first-child { text-align: left; } thead th { color: var(--soft); font-weight: 600; }
td.words { text-align: left; color: var(--soft); } .maybe { background: #8a6d00; }
.scroll { overflow-x: auto; margin-bottom: 1rem; } td.bad-cell { color: var(--bad); font-weight: 600; }
@media (max-width: 40rem) { .figures { grid-template-columns: 1fr; } }
)";

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
      found.where = r.json.at("name").get<std::string>();
    }
  }
  return found;
}

std::string radii_section(const Results& results) {
  const auto found = radii_findings(results);
  if (found.n_cases == 0) return "";
  std::string html = fmt::format(
      "<h2>Which stick radius do finite elements follow?</h2>\n<p>There are two. The <b>first-slip radius</b> bounds "
      "the "
      "elements that have never slipped since the start; it is the radius of the paper, its equations (19) to (27). "
      "The "
      "<b>shakedown radius</b> bounds the elements that no longer slip in the steady state, after early slip has "
      "locked in a "
      "favourable tangential force. Over {} cases with c/a ≥ 0.1 the stick zone of the finite elements in the steady "
      "state is at "
      "most {:.1e} a away from the shakedown radius",
      found.n_cases, found.steady_from_shakedown);
  if (found.steady_from_first_slip > 0)
    html += fmt::format(", and up to {:.2f} a away from the first-slip radius ({})", found.steady_from_first_slip,
                        html_escaped(found.where));
  const bool follows = found.steady_from_shakedown < found.steady_from_first_slip;
  html += fmt::format(
      ": it {} the shakedown radius. The zone that has never slipped is within {:.1e} a of the first-slip radius.",
      follows ? "follows" : "does not single out", found.never_slipped_from_first_slip);
  if (found.n_without_first_slip > 0)
    html += fmt::format(
        " In {} of the cases the first-slip criterion says that nothing sticks, while a steady stick zone exists.",
        found.n_without_first_slip);
  return html + "</p>\n";
}

std::string phase_section(const Results& results) {
  const auto figures = stick_radius_figures(results);
  if (figures.empty()) return "";
  return "<h2>Stick radius over the phase (figure 3 of the paper)</h2>\n" + figures_html(figures) +
         "<h2>Differences</h2>\n" + figures_html(difference_figures(results));
}

/// Is |G|/G0 all that counts? Largest differences per rheology.
std::string rheology_section(const Results& results) {
  std::map<std::string, Results> by_rheology;
  for (const auto& r : results)
    if (r.swept_over("Motion / Phase") && r.has_one_frequency() && !r.has_forces())
      by_rheology[r.text("scene", "rheology")].push_back(r);
  if (by_rheology.size() < 2) return "";
  Table table{{"rheology", "ρ", "cases", "first slip, largest difference", "shakedown, largest difference",
               "cycles to the steady state"}};
  for (const auto& [name, members] : by_rheology) {
    int most_cycles = 0;
    for (const auto& r : members) most_cycles = std::max(most_cycles, r.json.at("cost").value("cycles", 0));
    table.rows.push_back(
        {name, number_text(members.front().number("mdr", "modulus_ratio"), "{:.6f}"), fmt::format("{}", members.size()),
         number_text(extreme_of(members, "stick_radius_first_slip").difference),
         number_text(extreme_of(members, "stick_radius_shakedown").difference), fmt::format("up to {}", most_cycles)});
  }
  return "<h2>Does only the modulus ratio matter?</h2>\n<p>The paper says that the rheology enters the stick radius "
         "through ρ = |G(ω)|/G'(0) alone. Finite elements with different rheologies:</p>\n" +
         html_of(table);
}

std::string difference_text(const StoredResult& r, const char* key) {
  const auto& comparison = r.json.at("comparison");
  return comparison.contains(key) ? number_text(comparison[key]["difference"], "{:+.1e}") : "–";
}

std::string bar_text(const StoredResult& r, const char* key) {
  const auto& comparison = r.json.at("comparison");
  return comparison.contains(key) ? number_text(comparison[key]["error_bar"], "{:.0e}") : "–";
}

std::string limiting_section(const Results& results) {
  const auto figures = limiting_profile_figures(results);
  if (figures.empty()) return "";
  Table table{{"case", "amplitude at which slip begins", "± bar", "slip inside c", "force outside c", "normal force",
               "flank touches at", "a<sub>∞</sub> / a<sub>0</sub>"}};
  for (const auto& r : results) {
    if (!r.swept_over("Wear / Stick radius ratio")) continue;
    const auto fe = [&](const char* key) { return r.number("fe", key); };
    table.rows.push_back(
        {r.json.at("name").get<std::string>(), fmt::format("{:.6f}", fe("limiting_amplitude")),
         bar_text(r, "limiting_amplitude"), number_text(fe("slip_inside_stick_zone")),
         number_text(fe("force_outside_stick_zone")), difference_text(r, "normal_force_max"),
         fmt::format("{:.6f} d_max", fe("touch_indentation")),
         fmt::format("{:.4f}", r.number("mdr", "worn_radius") / r.number("scene", "contact_radius_unworn"))});
  }
  return "<h2>The state in which nothing wears any more (figure 4 of the paper)</h2>\n<p>Here the limiting profile "
         "itself is the indenter, and it oscillates with a motion whose shakedown radius is its c. In the periodic "
         "state the finite elements have to find no slip inside c and no pressure outside. That c is where the mesh "
         "has a node, so what they say about it is an amplitude: how far the tangential motion may grow, over that of "
         "MDR, "
         "before the periodic state begins to slip inside c. 1: with the very amplitude that MDR has for this "
         "c.</p>\n" +
         figures_html(figures) + html_of(table) +
         "<p class=\"soft\">Slip over the tangential amplitude, force outside c over the normal force, at the worst "
         "instant; difference of the largest normal force relative to MDR.</p>\n";
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
std::string motions_section(const Results& results) {
  Table table{{"case", "normal", "tangential", "c first slip, MDR", "finite elements", "± bar", "c shakedown, MDR",
               "finite elements", "± bar"}};
  for (const auto& r : results) {
    if (r.has_one_frequency()) continue;
    const auto radius = [&](const char* section, const char* key) {
      return number_text(r.number(section, key) / r.number("scene", "contact_radius_unworn"), "{:.5f}");
    };
    table.rows.push_back({r.json.at("name").get<std::string>(), frequencies_text(r, "normal_harmonics", "frequency"),
                          frequencies_text(r, "tangential_harmonics", "tangential_frequency")});
    for (const char* key : {"stick_radius_first_slip", "stick_radius_shakedown"})
      for (const auto& cell : {radius("mdr", key), radius("fe", key), bar_text(r, key)})
        table.rows.back().push_back(cell);
  }
  if (table.rows.empty()) return "";
  return "<h2>Other motions</h2>\n<p>Frequencies that differ between the directions, or several of them. Radii over "
         "the unworn contact radius at the largest indentation. Frequencies without a common period let every lag "
         "between the directions come by: MDR takes all of them, the finite elements a cycle nearby, and the bar "
         "counts what that leaves out.</p>\n" +
         html_of(table);
}

/// "largest contact radius in m"
std::string title_with_unit(const std::string& key) {
  const auto quantity = quantity_of(key);
  if (!quantity) return key;
  const auto& traits = traits_of(*quantity);
  return *traits.unit ? fmt::format("{} in {}", traits.title, traits.unit) : traits.title;
}

std::string single_cases_section(const Results& results) {
  std::string html;
  for (const auto& r : results) {
    if (r.json.at("scene").contains("sweep")) continue;
    html += fmt::format("<h2>Case {}</h2>\n<p>{}: {}.</p>\n", html_escaped(r.family()),
                        html_escaped(r.text("scene", "shape") + ", " + r.text("scene", "rheology")),
                        r.json.at("pass").get<bool>() ? "finite elements and MDR agree" : "they do not agree");
    Table table{{"quantity", "MDR", "finite elements", "difference", "tolerance"}};
    for (const auto& [key, d] : r.json.at("comparison").items())
      table.rows.push_back({title_with_unit(key), number_text(r.number("mdr", key.c_str()), "{:.6g}"),
                            number_text(r.number("fe", key.c_str()), "{:.6g}"),
                            bad_if(!d.at("pass").get<bool>(), number_text(d.at("difference"))),
                            number_text(d.at("tolerance"))});
    html += html_of(table) + figures_html(single_case_figures(r));
  }
  return html;
}

std::string cost_section(const Results& results) {
  double friction = 0, steps = 0, memory = 0;
  for (const auto& r : results) {
    const auto& cost = r.json.at("cost");
    friction += cost.at("seconds").value("friction_history", 0.0);
    steps += cost.value("time_steps", 0.0);
    memory = std::max(memory, cost.value("peak_memory_bytes", 0.0));
  }
  const auto& first = results.front().json.at("cost");
  std::string libraries;
  for (const auto& [name, version] : versions())
    libraries += fmt::format("{}{} {}", libraries.empty() ? "" : ", ", name, version);
  return fmt::format(
      "<h2>Method and cost</h2>\n<p>Mixed incompressible finite elements in Fourier harmonics on the meridian "
      "half-plane "
      "(normal n = 0, tangential n = 1), condensed on the contact rings by a MUMPS Schur complement; unilateral "
      "contact and "
      "Coulomb friction stepped through the viscoelastic history until it is periodic. A case like {} has {} degrees "
      "of freedom "
      "and takes {} time steps over {} cycles in {:.2f} s. All {} cases: {:.2g} time steps, {:.0f} s of friction "
      "histories on "
      "one core, peak memory {:.0f} MB.</p>\n<p class=\"soft\">{}</p>\n",
      html_escaped(results.front().json.at("name").get<std::string>()), first.value("dofs", 0),
      first.value("time_steps", 0L), first.value("cycles", 0), first.at("seconds").value("friction_history", 0.0),
      results.size(), steps, friction, memory / 1e6, html_escaped(libraries));
}

std::string all_cases_section(const Results& results) {
  Table table{{"case", "c first slip, MDR", "FE", "c shakedown, MDR", "FE", "contact radius", "normal force", ""}};
  for (const auto& r : results) {
    const bool pass = r.json.at("pass").get<bool>();
    const auto length = [&](const char* section, const char* key) {
      return number_text(r.number(section, key) / r.number("scene", "contact_radius_unworn"), "{:.5f}");
    };
    table.rows.push_back({r.json.at("name").get<std::string>(), length("mdr", "stick_radius_first_slip"),
                          length("fe", "stick_radius_first_slip"), length("mdr", "stick_radius_shakedown"),
                          length("fe", "stick_radius_shakedown"), difference_text(r, "contact_radius_max"),
                          difference_text(r, "normal_force_max"), bad_if(!pass, pass ? "agree" : "disagree")});
  }
  return "<h2>All cases</h2>\n<details><summary>Stick radii and differences of every case</summary>\n" +
         html_of(table) +
         "<p class=\"soft\">Radii over the unworn contact radius at the largest indentation; – : nothing sticks, or "
         "not compared.</p></details>\n";
}

}  // namespace

fs::path write_report(const fs::path& folder) {
  const auto results = read_results(folder);
  const auto of_results = [&](std::string (*section)(const Results&)) {
    return results.empty() ? "" : section(results);
  };
  std::string sections;
  for (const auto& section :
       {of_results(verdict_section), of_results(radii_section), of_results(phase_section), of_results(rheology_section),
        of_results(motions_section), of_results(forces_section), of_results(limiting_section), of_results(wear_section),
        of_results(single_cases_section), of_results(budget_section), trade_section(folder),
        section_of(folder / "tolerance.json", suite_section), section_of(folder / "extremes.json", suite_section),
        section_of(folder / "random.json", suite_section), section_of(folder / "exact.json", convergence_section),
        of_results(cost_section), of_results(all_cases_section)})
    sections += section;
  if (sections.empty())
    throw InputError(
        fmt::format("{}: there is no result.json, trade.json or JSON of a suite below it; expected a folder that "
                    "fretval run, trade or check --json has written",
                    folder.string()));
  fs::path file = folder / "index.html";
  write_file(file,
             fmt::format("<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
                         "content=\"width=device-width, initial-scale=1\"><title>fretval: finite elements against "
                         "MDR</title><style>{}</style></head><body>\n<h1>Finite elements against MDR</h1>\n<p "
                         "class=\"soft\">Fretting of an elastomer under combined normal and tangential "
                         "oscillation</p>\n{}</body></html>\n",
                         style, sections));
  return file;
}

}  // namespace fretval
