#include "comparison/command_line/commands.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "comparison/accuracy/prepared_case.h"
#include "comparison/case/case_file.h"
#include "comparison/command_line/exit_codes.h"
#include "comparison/command_line/mdr_command.h"
#include "comparison/command_line/run_command.h"
#include "comparison/command_line/terminal.h"
#include "comparison/command_line/trade_command.h"
#include "comparison/report/report.h"
#include "comparison/support/files.h"
#include "comparison/support/log.h"
#include "comparison/support/stopwatch.h"
#include "comparison/verification/exact/convergence_json.h"
#include "comparison/verification/exact/convergence_rows.h"
#include "comparison/verification/exact/exact_rows.h"
#include "comparison/verification/small/small_suite.h"
#include "fem/condensation/petsc_session.h"
#include "meshes/msh_file.h"
#include "meshes/quality.h"

namespace fretval {
namespace {

namespace fs = std::filesystem;

int run_small(const fs::path& meshes, const std::string& junit) {
  const auto lines = run_small_suite(small_cases(meshes));
  bool all = true;
  for (const auto& line : lines) {
    const bool pass = line.pass && line.failure.empty();
    all = all && pass;
    fmt::print("{} {:<40} {}\n", pass ? "pass" : "FAIL", line.name,
               line.failure.empty() ? differences_of(line) : line.failure);
  }
  if (!junit.empty()) write_file(junit, junit_xml(lines));
  fmt::print("{}\n", all ? "finite elements and MDR agree" : "finite elements and MDR DISAGREE");
  return all ? exit_agree : exit_disagree;
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

struct CheckOptions {
  std::string suite = "small", meshes = small_meshes().string(), junit, json;
};

int run_check_suite(const CheckOptions& options) {
  Stopwatch watch;
  const fem::PetscSession session;
  if (options.suite != "small" && options.suite != "exact")
    throw InputError(fmt::format("--suite {}: expected small or exact", options.suite));
  const int exit_code = options.suite == "small" ? run_small(options.meshes, options.junit)
                                                 : run_exact_suite(options.junit, options.json);
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
    Proof proof = Proof::tolerance;
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
  run->add_option("--proof", options->proof,
                  "How far the finite elements are proved: none, the answer alone; bars, with error bars whatever they "
                  "are; tolerance, refined until the bars meet the tolerance")
      ->transform(CLI::CheckedTransformer(
          std::map<std::string, Proof>{{"none", Proof::none}, {"bars", Proof::bars}, {"tolerance", Proof::tolerance}}))
      ->default_str("tolerance");
  run->callback(
      [=, &command] { command = [=] { return run_cases(options->files, options->output, options->proof); }; });

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
