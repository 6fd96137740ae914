#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "comparison/accuracy/verdict.h"
#include "comparison/report/text/filling.h"
#include "comparison/results/results_folder.h"

namespace fretval {

// Sections of a page, and what stands in them: what the templates of their names are filled with. A section that has
// nothing to show is null.

/// Summary of the comparisons of a quantity over the results: the largest difference, with the bar (of both methods
/// together) and the tolerance of its case.
struct Extreme {
  double size = 0, tolerance = 0, bar = 0;
  std::string name;
  std::size_t n_compared = 0, n_asked = 0;
  std::map<Verdict, std::size_t> counts = {};
};
Extreme extreme_of(const std::vector<StoredResult>& results, Quantity quantity);

/// How many cases agree, and the largest difference and error bar of each quantity.
Filling verdict_section(const std::vector<StoredResult>& results);

/// Which sources make up the error bars, median and largest over the results. Null if none was measured.
Filling budget_section(const std::vector<StoredResult>& results);

/// What a page begins with, for its template: "title", the name of the case or what several are; "date" of the newest
/// result; "libraries" and "citation" of the program; "earlier", how many results are not of the run that writes the
/// page. of_this_run: names of its cases; empty: not known, and nothing is told. no_results: the title of a page
/// without any.
Filling heading_of(const std::vector<StoredResult>& results, const std::set<std::string>& of_this_run,
                   const std::string& no_results);

/// The cases that are no points of a sweep, each with its answer, the scene and its plots. Null if there is none.
Filling cases_section(const std::vector<StoredResult>& results);

/// What a case file prescribes (`inputs` of a JSON, see inputs_json) by its sections, for the template `scene`.
Filling inputs_of(const nlohmann::ordered_json& scene);

/// For the template `scene`: the sketch of a case, all that its file prescribes, with units, and the dimensionless
/// groups.
Filling scene_of(const StoredResult& result);

/// The scene of the first case of each sweep. Null without a sweep.
Filling scenes_section(const std::vector<StoredResult>& results);

/// For the template `assumptions`: what a case takes for granted, each with a number of the case that says how far it
/// holds: slope at the edge of the contact, a parabola's distance from the arc, how close to lifting off, how deep a
/// layer has to be to count as a half-space, and what the far boundary of the finite elements does.
Filling assumptions_of(const StoredResult& result);

/// For the template `table`: what a rig has measured beside both methods, and how they differ from it; null: nothing
/// was measured.
Filling measured_table(const StoredResult& result);

/// How the data of a case were processed, in a sentence for each; null: they were taken as they are.
Filling data_sentences(const StoredResult& result);

/// How finite elements compute, and what all of it took: the first case at its chosen resolution, and the computations
/// of all proofs.
Filling cost_section(const std::vector<StoredResult>& results);

/// Section about the cases in which a force is prescribed: stick radii, what the indenter does under the forces,
/// and when the contact slides as a whole. Null if there is none.
Filling forces_section(const std::vector<StoredResult>& results);

/// Section about families of cases over any swept entry: both stick radii and what else is compared, with error bars.
/// Phases under the indenters of the paper and worn profiles have sections of their own. Null if there is none.
Filling sweeps_section(const std::vector<StoredResult>& results);

/// Writes sweep.csv beside the folders of the cases of each family: the value of the entry, then each quantity by MDR,
/// by finite elements, and its error bar, in SI units; empty where there is no value.
void write_sweeps(const std::vector<StoredResult>& results);

/// Section about indenters that wear: where wear ends by finite elements and by MDR, and the course of one case of each
/// family. Null if no result has any wear.
Filling wear_section(const std::vector<StoredResult>& results);

/// Section about indenters that wear under friction as a vector, to shapes that are not axisymmetric: the zone that
/// sticks in the end beside MDR's limit, the course of the wear, and worn profiles in four directions. Null if there
/// are none.
Filling surface_wear_section(const std::vector<StoredResult>& results);

/// For the template `trust`: how far MDR can be trusted in a case, of a trust.json (see ladder_json): the headline, the
/// ladder of assumptions as a waterfall and as a table, the maps of MDR's error with the case on them, what is not
/// computed, how it was computed in words that can be copied, and the inputs. Throws InputError for another JSON.
Filling trust_section(const nlohmann::ordered_json& trust);

/// Section about every trade.json below a folder: recommended settings next to the tool's own choice, the front,
/// the other levels, what each axis gives alone, figures. Null if there is none. Throws InputError if one cannot be
/// read.
Filling trade_section(const std::filesystem::path& folder);

/// The tables of a trade.json for a terminal.
std::string trade_text(const nlohmann::ordered_json& trade);

/// Section of the suite `exact` as convergence_json writes it: a table with the errors at each resolution, the
/// orders and the verdicts. Throws nlohmann::json::exception for JSON of another kind.
Filling convergence_section(const nlohmann::ordered_json& rows);

/// The text of the section for a terminal.
std::string convergence_text(const nlohmann::ordered_json& rows);

/// Section of a suite as suite_json writes it: verdict and counts, a line for each quantity and tolerance, all error
/// bars over their errors as a figure where all rows are there, and the rows with their case files. Throws
/// nlohmann::json::exception for JSON of another kind.
Filling suite_section(const nlohmann::ordered_json& json);

/// The text of the section for a terminal, without the figure and the case files.
std::string suite_text(const nlohmann::ordered_json& json);

}  // namespace fretval
