#include "comparison/command_line/commands.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "comparison/case/case_file.h"
#include "comparison/command_line/exit_codes.h"
#include "comparison/command_line/mdr_command.h"
#include "comparison/command_line/terminal.h"
#include "comparison/command_line/trade_command.h"
#include "comparison/report/report.h"
#include "comparison/results/batch.h"
#include "comparison/results/case_result.h"
#include "comparison/support/files.h"
#include "comparison/support/folder_lock.h"
#include "comparison/support/log.h"
#include "comparison/support/stopwatch.h"
#include "comparison/verification/exact/convergence_json.h"
#include "comparison/verification/exact/convergence_rows.h"
#include "comparison/verification/exact/exact_rows.h"
#include "comparison/verification/extremes/extremes.h"
#include "comparison/verification/extremes/extremes_json.h"
#include "comparison/verification/extremes/extremes_table.h"
#include "comparison/verification/random_cases/random_json.h"
#include "comparison/verification/random_cases/random_suite.h"
#include "comparison/verification/random_cases/random_table.h"
#include "comparison/verification/small/small_suite.h"
#include "comparison/verification/tolerance/tolerance_cases.h"
#include "comparison/verification/tolerance/tolerance_json.h"
#include "comparison/verification/tolerance/tolerance_suite.h"
#include "comparison/verification/tolerance/tolerance_table.h"
#include "fem/condensation/petsc_session.h"
#include "meshes/msh_file.h"
#include "meshes/quality.h"

namespace fretval {
namespace {

namespace fs = std::filesystem;

std::vector<Case> read_cases(const std::vector<std::string>& files) {
  std::vector<Case> cases;
  for (const auto& file : files)
    for (auto& scene : read_case_file(file)) cases.push_back(std::move(scene));
  return cases;
}

int exit_code_of(const std::vector<BatchLine>& lines) {
  const auto failed = [](const BatchLine& line) { return !line.failure.empty(); };
  if (std::any_of(lines.begin(), lines.end(), failed)) return exit_numerics_failed;
  const auto agrees = [](const BatchLine& line) { return line.pass; };
  return std::all_of(lines.begin(), lines.end(), agrees) ? exit_agree : exit_disagree;
}

/// Says what the scenes do not need, and so is not computed.
void log_left_out(const std::vector<PreparedCase>& prepared) {
  std::map<std::string, int> counts;
  for (const auto& one : prepared)
    for (const auto& words : left_out(one.fem)) ++counts[words];
  for (const auto& [words, n] : counts) log::info(fmt::format("{} of {} cases: {}", n, prepared.size(), words));
}

int run_cases(const std::vector<std::string>& files, const fs::path& output) {
  Stopwatch watch;
  const auto prepared = prepare(read_cases(files));
  for (const auto& one : prepared)
    for (const auto& warning : one.scene.warnings) log::warn(warning);
  log_left_out(prepared);
  const FolderLock lock(output);
  const fem::PetscSession session;
  Progress progress;
  BatchHooks hooks;
  hooks.progress = [&](const BatchLine& line, std::size_t n_done, std::size_t n_cases) {
    progress.show(line, n_done, n_cases);
  };
  const auto lines = run_batch(prepared, output, hooks);
  print_verdicts(lines);
  if (std::any_of(lines.begin(), lines.end(), [](const BatchLine& line) { return line.failure.empty(); }))
    log::info(fmt::format("report: {}", write_report(output).string()));
  log::info(fmt::format("{} cases in {:.1f} s", lines.size(), watch.lap()));
  return exit_code_of(lines);
}

int run_small_suite(const fs::path& meshes, const std::string& junit) {
  const auto lines = run_check(check_scenes(meshes));
  bool all = true;
  for (const auto& line : lines) {
    const bool pass = line.pass && line.failure.empty();
    all = all && pass;
    fmt::print("{} {:<40} {}\n", pass ? "pass" : "FAIL", line.name,
               line.failure.empty() ? differences_of(line) : line.failure);
  }
  if (!junit.empty()) write_file(junit, junit_xml(lines));
  fmt::print("{}\n", all ? "finite elements and MDR agree" : "finite elements and MDR DISAGREE");
  return exit_code_of(lines);
}

int run_exact_suite(const std::string& junit, const std::string& json) {
  const auto rows = exact_rows();
  fmt::print("{}", convergence_table(rows));
  if (!junit.empty()) write_file(junit, convergence_junit(rows));
  if (!json.empty()) write_file(json, convergence_json(rows).dump(2) + "\n");
  const bool all =
      std::all_of(rows.begin(), rows.end(), [](const ConvergenceRow& row) { return failure_of(row).empty(); });
  const auto n_unmet =
      std::count_if(rows.begin(), rows.end(), [](const ConvergenceRow& row) { return meets_goal(row) == false; });
  fmt::print("{}; {} of {} rows do not meet the goal of the project\n",
             all ? "all rows are within their tolerance" : "rows FAIL", n_unmet, rows.size());
  return all ? exit_agree : exit_disagree;
}

void write_tolerance_cases(const std::vector<double>& tolerances, const fs::path& folder) {
  for (const double tolerance : tolerances) {
    const auto of_tolerance = folder / entry_text(tolerance);
    fs::create_directories(of_tolerance);
    for (const auto& [name, entries] : tolerance_entries(tolerance))
      write_file(of_tolerance / (name + ".prm"), case_text(entries));
  }
}

int run_tolerance(const ToleranceSuiteOptions& options, const std::string& junit, const std::string& json,
                  const fs::path& cases) {
  if (!cases.empty()) write_tolerance_cases(options.tolerances, cases);
  const auto records = run_tolerance_suite(options);
  fmt::print("{}", tolerance_table(records));
  if (!junit.empty()) write_file(junit, tolerance_junit(records));
  if (!json.empty()) write_file(json, tolerance_json(records).dump(2) + "\n");
  const auto n_pass =
      std::count_if(records.begin(), records.end(), [](const ToleranceRecord& record) { return record.passes(); });
  fmt::print("{} of {} meet their tolerance, with every error covered by its bar\n", n_pass, records.size());
  return static_cast<std::size_t>(n_pass) == records.size() ? exit_agree : exit_disagree;
}

int run_extremes_suite(const std::vector<ExtremeRow>& rows, const std::string& junit, const std::string& json) {
  const auto records = run_extremes(rows);
  fmt::print("{}", extremes_table(records));
  if (!junit.empty()) write_file(junit, extremes_junit(records));
  if (!json.empty()) write_file(json, extremes_json(records).dump(2) + "\n");
  return count(records, ExtremeVerdict::fails) == 0 ? exit_agree : exit_disagree;
}

int run_soak_suite(const SoakOptions& options, const std::string& junit, const std::string& json,
                   const fs::path& worst) {
  const auto run = run_soak(options, [&](std::size_t n_done) {
    if (n_done % 1000 == 0) log::info(fmt::format("{} of {} cases", n_done, options.n_cases));
  });
  const auto summary = summary_of(run);
  fmt::print("{}", soak_table(run, summary));
  if (!junit.empty()) write_file(junit, soak_junit(summary));
  if (!json.empty()) write_file(json, soak_json(run, summary).dump(2) + "\n");
  if (!worst.empty()) {
    fs::create_directories(worst);
    for (const auto* record : summary.worst)
      write_file(worst / fmt::format("soak-{}-{}.prm", record->draw.seed, record->draw.number),
                 case_text(soak_entries(record->draw)));
  }
  return summary.passes() ? exit_agree : exit_disagree;
}

struct CheckOptions {
  std::string suite = "small", meshes = small_meshes().string(), junit, json;
  ToleranceSuiteOptions tolerance;
  SoakOptions soak;
  std::string tolerance_cases, worst;
  bool only_short = false;
  std::string family;
};

std::vector<ExtremeRow> rows_of(const CheckOptions& options) {
  auto rows = only_family(options.only_short ? short_extreme_rows() : extreme_rows(), options.family);
  if (rows.empty()) throw InputError(fmt::format("--family {}: no family of the suite contains that", options.family));
  return rows;
}

int run_suite(const CheckOptions& options) {
  if (options.suite == "small") return run_small_suite(options.meshes, options.junit);
  if (options.suite == "exact") return run_exact_suite(options.junit, options.json);
  if (options.suite == "tolerance")
    return run_tolerance(options.tolerance, options.junit, options.json, options.tolerance_cases);
  if (options.suite == "extremes") return run_extremes_suite(rows_of(options), options.junit, options.json);
  if (options.suite == "soak") return run_soak_suite(options.soak, options.junit, options.json, options.worst);
  throw InputError(fmt::format("--suite {}: expected small, exact, tolerance, extremes or soak", options.suite));
}

int run_check_suite(const CheckOptions& options) {
  if (!options.json.empty() && options.suite == "small")
    throw InputError("--json: it belongs to the suites exact, tolerance, extremes and soak");
  if ((options.soak.only || !options.worst.empty()) && options.suite != "soak")
    throw InputError("--only and --write-worst: they belong to the suite soak");
  if (!options.tolerance_cases.empty() && options.suite != "tolerance")
    throw InputError("--write-cases: it belongs to the suite tolerance");
  if ((options.only_short || !options.family.empty()) && options.suite != "extremes")
    throw InputError("--short and --family: they belong to the suite extremes");
  Stopwatch watch;
  const fem::PetscSession session;
  const int exit_code = run_suite(options);
  log::info(fmt::format("suite {} in {:.1f} s", options.suite, watch.lap()));
  return exit_code;
}

int write_mesh(const std::string& file, const std::string& output) {
  const auto cases = read_case_file(file);
  if (cases.size() != 1)
    throw InputError(fmt::format("{}: a sweep has many meshes; expected a file with a single case", file));
  const auto prepared = prepare(cases).front();
  auto mesh = mesh_of(prepared.fem.body);
  for (auto& node : mesh.nodes)
    for (double& x : node) x *= prepared.fem.units.length;
  meshes::write_msh(mesh, output);
  const auto q = meshes::quality(mesh);
  fmt::print("{}: {} cells, {} nodes, smallest scaled Jacobian {:.2f}\n", output, q.n_cells, q.n_nodes,
             q.min_scaled_jacobian);
  return exit_agree;
}

}  // namespace

void add_commands(CLI::App& app, Command& command) {
  struct Options {
    std::vector<std::string> files;
    std::string file, output = "results", mesh;
    MdrOptions mdr;
    CheckOptions check;
  };
  const auto options = std::make_shared<Options>();

  auto* mdr = app.add_subcommand("mdr", "The analytic answer alone");
  mdr->add_option("case", options->file, "Case file (.prm or .json)")->required();
  mdr->add_flag("--json", options->mdr.json, "Print JSON");
  mdr->add_flag("--springs", options->mdr.springs,
                "Also step the spring foundation through the motion, as a second way");
  mdr->add_option("--fields", options->mdr.fields,
                  "Write pressure, traction and displacements on the surface to this CSV");
  mdr->callback([=, &command] { command = [=] { return run_mdr(options->file, options->mdr); }; });

  auto* run = app.add_subcommand("run", "MDR and finite elements, compared; writes the results and the report");
  run->add_option("cases", options->files, "Case files (.prm or .json)")->required();
  run->add_option("-o,--output", options->output, "Folder for the results")->capture_default_str();
  run->callback([=, &command] { command = [=] { return run_cases(options->files, options->output); }; });

  auto* check = app.add_subcommand(
      "check",
      "CI check: MDR against finite elements on small meshes, finite elements against "
      "exact solutions, the errors of the "
      "chosen settings against the tolerance, scenes at the ends of every parameter, or random scenes");
  check->add_option("--suite", options->check.suite, "Which suite: small, exact, tolerance, extremes, soak")
      ->capture_default_str();
  check->add_option("--meshes", options->check.meshes, "Folder with coarse.msh and fine.msh, for the suite small")
      ->capture_default_str();
  check->add_option("--junit", options->check.junit, "Also write JUnit XML to this file");
  check->add_option("--json", options->check.json,
                    "Also write everything that was measured to this file; suites exact, tolerance, extremes and soak");
  check->add_option("--tolerances", options->check.tolerance.tolerances, "Suite tolerance: at which tolerances")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  check->add_flag("!--no-costs", options->check.tolerance.costs,
                  "Suite tolerance: do not search for the cheapest settings");
  check->add_option("--write-cases", options->check.tolerance_cases,
                    "Suite tolerance: folder for its case files, one for each case and tolerance");
  check->add_flag("--short", options->check.only_short, "Suite extremes: a few seconds of it");
  check->add_option("--family", options->check.family, "Suite extremes: only the families whose name contains this");
  check->add_option("--cases", options->check.soak.n_cases, "Suite soak: how many random cases")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000000));
  check->add_option("--seed", options->check.soak.seed, "Suite soak: of the random cases")->capture_default_str();
  check->add_option("--only", options->check.soak.only, "Suite soak: only the case of this number, from 0");
  check->add_option("--write-worst", options->check.worst, "Suite soak: folder for case files of the ten worst");
  check->callback([=, &command] { command = [=] { return run_check_suite(options->check); }; });

  auto* report = app.add_subcommand("report", "One self-contained HTML page from the results in a folder");
  report->add_option("folder", options->file, "Folder with results")->required();
  report->callback([=, &command] {
    command = [=] {
      fmt::print("{}\n", write_report(options->file).string());
      return exit_agree;
    };
  });

  auto* trade = app.add_subcommand("trade", "The speed-accuracy front of a case; writes trade.json");
  trade->add_option("case", options->file, "Case file (.prm or .json) with a single case")->required();
  trade->add_option("-o,--output", options->output, "Folder for the results")->capture_default_str();
  trade->callback([=, &command] { command = [=] { return run_trade(options->file, options->output); }; });

  auto* mesh = app.add_subcommand("mesh", "The mesh of a case alone");
  mesh->add_option("case", options->file, "Case file (.prm or .json)")->required();
  mesh->add_option("-o,--output", options->mesh, "Mesh file (.msh)")->required();
  mesh->callback([=, &command] { command = [=] { return write_mesh(options->file, options->mesh); }; });
}

}  // namespace fretval
