#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <random>

#include "comparison/command_line/ending.h"
#include "comparison/command_line/verbs.h"
#include "comparison/report/sections/sections.h"
#include "comparison/support/files.h"
#include "comparison/support/log.h"
#include "comparison/support/stopwatch.h"
#include "comparison/verification/exact/exact_rows.h"
#include "comparison/verification/suite.h"
#include "comparison/verification/suites.h"
#include "fem/condensation/petsc_session.h"

namespace fretval {
namespace {

namespace fs = std::filesystem;

/// A suite that was run, as it is shown and written.
struct SuiteOutcome {
  std::string table, junit;
  nlohmann::ordered_json json;
  int exit_code;
};

SuiteOutcome outcome_of(const SuiteRun& run) {
  auto json = suite_json(run);
  return {suite_text(json), suite_junit(run), std::move(json), exit_code_of(run)};
}

SuiteOutcome check_exact() {
  const auto rows = exact_rows();
  auto json = convergence_json(rows);
  return {convergence_text(json), convergence_junit(rows), std::move(json), exit_code_of(rows)};
}

void write_case_file(const fs::path& folder, const SuiteCase& one) {
  fs::create_directories(folder);
  write_file(folder / (one.name + ".prm"), one.text);
}

SuiteOutcome check_tolerance(const CheckOptions& options) {
  if (!options.cases_folder.empty())
    for (const double tolerance : options.tolerances)
      for (const auto& one : tolerance_cases(tolerance))
        write_case_file(fs::path(options.cases_folder) / fmt::format("{}", tolerance), one);
  return outcome_of(run_tolerance_suite(options.tolerances));
}

SuiteOutcome check_extremes(const CheckOptions& options) {
  const auto cases = only_family(options.only_short ? short_extreme_cases() : extreme_cases(), options.family);
  if (cases.empty()) throw InputError(fmt::format("--family {}: no family of the suite contains that", options.family));
  return outcome_of(run_extreme_suite(cases));
}

/// Error bars were made with cases in view that were drawn before: without a seed there are new ones.
SuiteOutcome check_random(const CheckOptions& options) {
  if (options.only && !options.seed) throw InputError("--only: of which cases? Expected their --seed as well");
  const auto seed = options.seed.value_or(std::random_device()());
  if (!options.seed) log::info(fmt::format("new cases: --seed {} draws them again", seed));
  const auto run = run_random_suite({seed, options.n_cases, options.only, options.with_cycle});
  if (!options.worst_folder.empty())
    for (const auto* row : worst_rows(run.rows)) write_case_file(options.worst_folder, row->asked);
  return outcome_of(run);
}

SuiteOutcome check(const CheckOptions& options) {
  if (options.suite == "small") return outcome_of(run_small_suite(options.meshes));
  if (options.suite == "exact") return check_exact();
  if (options.suite == "tolerance") return check_tolerance(options);
  if (options.suite == "extremes") return check_extremes(options);
  if (options.suite == "random") return check_random(options);
  throw InputError(fmt::format("--suite {}: expected small, exact, tolerance, extremes or random", options.suite));
}

}  // namespace

void add_check_options(CLI::App& verb, CheckOptions& options) {
  options.meshes = small_meshes().string();
  options.tolerances = {1e-2, 1e-3, 1e-4};
  auto* suite = verb.add_option("--suite", options.suite, "Which suite: small, exact, tolerance, extremes, random")
                    ->capture_default_str();
  verb.add_option("--junit", options.junit, "Also write JUnit XML to this file");
  auto* json = verb.add_option("--json", options.json, "Also write everything that was measured to this file");
  verb.add_option("--cases", options.inputs,
                  "Instead of a suite case files, or folders of them, as `run` holds them to MDR; keeps no results")
      ->excludes(suite)
      ->excludes(json);
  const auto belongs = [&](CLI::Option* option, const char* suite) { options.of[option] = suite; };
  belongs(verb.add_option("--meshes", options.meshes, "Suite small: folder with coarse.msh and fine.msh")
              ->capture_default_str(),
          "small");
  belongs(verb.add_option("--tolerances", options.tolerances, "Suite tolerance: at which tolerances")
              ->capture_default_str()
              ->check(CLI::PositiveNumber),
          "tolerance");
  belongs(verb.add_option("--write-cases", options.cases_folder,
                          "Suite tolerance: folder for its case files, one for each case and tolerance"),
          "tolerance");
  belongs(verb.add_flag("--short", options.only_short, "Suite extremes: the first of each family"), "extremes");
  belongs(verb.add_option("--family", options.family, "Suite extremes: only the families whose name contains this"),
          "extremes");
  belongs(verb.add_option("--count", options.n_cases, "Suite random: how many cases")
              ->capture_default_str()
              ->check(CLI::Range(1, 1000000)),
          "random");
  belongs(verb.add_option("--seed", options.seed, "Suite random: of the cases; otherwise a new one"), "random");
  belongs(verb.add_option("--only", options.only, "Suite random: only the case of this number, from 0"), "random");
  belongs(verb.add_flag("--cycle", options.with_cycle,
                        "Suite random: hold forces and energies of a cycle to their bars as well"),
          "random");
  belongs(verb.add_option("--write-worst", options.worst_folder, "Suite random: folder for case files of the worst"),
          "random");
}

int run_check(const CheckOptions& options) {
  for (const auto& [option, suite] : options.of)
    if (option->count() > 0 && (suite != options.suite || !options.inputs.empty()))
      throw InputError(fmt::format("{}: it belongs to the suite {}", option->get_name(), suite));
  prepare_output_file("--junit", options.junit);
  prepare_output_file("--json", options.json);
  if (!options.inputs.empty()) {
    RunOptions run;
    run.inputs = options.inputs;
    run.output.clear();
    run.junit = options.junit;
    run.store.none = true;
    return run_cases(run);
  }
  Stopwatch watch;
  const fem::PetscSession session;
  const auto outcome = check(options);
  fmt::print("{}", outcome.table);
  if (!options.junit.empty()) write_file(options.junit, outcome.junit);
  if (!options.json.empty()) write_file(options.json, outcome.json.dump(2) + "\n");
  log::info(fmt::format("suite {} in {:.1f} s", options.suite, watch.lap()));
  return outcome.exit_code;
}

int exit_code_of(const SuiteRun& run) {
  if (run.passes()) return exit_agree;
  const auto has_no_answer = [](const SuiteRow& row) {
    return !row.failure.empty() || (row.asked.refusal.empty() && !row.refusal.empty());
  };
  return std::any_of(run.rows.begin(), run.rows.end(), has_no_answer) ? exit_numerics_failed : exit_disagree;
}

int exit_code_of(const std::vector<ConvergenceRow>& rows) {
  const auto passes = [](const ConvergenceRow& row) { return failure_of(row).empty(); };
  return std::all_of(rows.begin(), rows.end(), passes) ? exit_agree : exit_disagree;
}

}  // namespace fretval
