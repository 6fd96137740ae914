#include "comparison/command_line/commands.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>

#include "comparison/accuracy/prepared_case.h"
#include "comparison/case_file/case_file.h"
#include "comparison/command_line/ending.h"
#include "comparison/command_line/verbs.h"
#include "comparison/report/report.h"
#include "comparison/support/log.h"
#include "comparison/support/text.h"
#include "meshes/msh_file.h"
#include "meshes/quality.h"

namespace fretval {
namespace {

namespace fs = std::filesystem;

int write_mesh(const std::string& file, const std::string& output) {
  if (fs::path(output).extension() != ".msh")
    throw InputError(fmt::format("--output {}: expected a name that ends in .msh, the format that is written", output));
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

Proof proof_of(const std::string& word) {
  const std::map<std::string, Proof> proofs{
      {"none", Proof::none}, {"bars", Proof::bars}, {"tolerance", Proof::tolerance}};
  const auto found = proofs.find(word);
  if (found != proofs.end()) return found->second;
  throw CLI::ValidationError(
      fmt::format("--proof {}", word),
      fmt::format("expected none, bars or tolerance{}", did_you_mean(word, {"none", "bars", "tolerance"})));
}

// What a verb takes lives as long as its callback.

void add_new_case(CLI::App& app, Command& command) {
  const auto file = std::make_shared<std::string>();
  const auto chosen = std::make_shared<NewCase>();
  auto* make = app.add_subcommand("new", "Write a commented case file, and the tables that it needs");
  make->add_option("case", *file, "Name of the case file (.prm)")->required();
  make->add_option("--shape", chosen->shape, fmt::format("{}", fmt::join(new_case_shapes(), ", ")))
      ->capture_default_str();
  make->add_option("--rheology", chosen->rheology, fmt::format("{}", fmt::join(new_case_rheologies(), ", ")))
      ->capture_default_str();
  make->callback([=, &command] { command = [=] { return write_new_case(*file, *chosen); }; });
}

void add_explain(CLI::App& app, Command& command) {
  const auto file = std::make_shared<std::string>();
  const auto entries = std::make_shared<bool>(false);
  auto* explain = app.add_subcommand("explain", "What a case is, before it is computed");
  auto* case_file = explain->add_option("case", *file, "Case file (.prm or .json)");
  explain->add_flag("--entries", *entries, "Every entry of a case file instead, in Markdown")->excludes(case_file);
  explain->callback([=, &command] {
    if (!*entries && file->empty()) throw CLI::RequiredError("case or --entries");
    command = [=] { return *entries ? print_entries() : explain_case(*file); };
  });
}

void add_compare(CLI::App& app, Command& command) {
  const auto file = std::make_shared<std::string>(), other = std::make_shared<std::string>();
  auto* compare = app.add_subcommand("compare",
                                     "What changed between two folders of results; exits with 1 if a value moved "
                                     "beyond its bars, or a verdict changed");
  compare->add_option("before", *file, "Folder with results")->required();
  compare->add_option("after", *other, "Folder with results")->required();
  compare->callback([=, &command] { command = [=] { return compare_results(*file, *other); }; });
}

void add_mdr(CLI::App& app, Command& command) {
  const auto file = std::make_shared<std::string>();
  const auto options = std::make_shared<MdrOptions>();
  auto* mdr = app.add_subcommand("mdr", "The analytic answer alone");
  mdr->add_option("case", *file, "Case file (.prm or .json)")->required();
  mdr->add_flag("--json", options->json, "Print JSON");
  mdr->add_flag("--springs", options->springs, "Also step the spring foundation through the motion, as a second way");
  mdr->add_option("--fields", options->fields, "Write pressure, traction and displacements on the surface to this CSV");
  mdr->callback([=, &command] { command = [=] { return run_mdr(*file, *options); }; });
}

void add_run(CLI::App& app, Command& command) {
  const auto options = std::make_shared<RunOptions>();
  auto* run = app.add_subcommand("run", "MDR and finite elements, compared; writes the results and the report");
  run->add_option("cases", options->inputs, "Case files (.prm or .json), or folders of them")->required();
  run->add_option("-o,--output", options->output, "Folder for the results")->capture_default_str();
  run->add_option_function<std::string>(
         "--proof", [=](const std::string& word) { options->proof = proof_of(word); },
         "How far the finite elements are proved: none, the answer alone; bars, with error bars whatever they "
         "are; tolerance, refined until the bars meet the tolerance")
      ->default_str("tolerance");
  run->add_flag("--json", options->json, "Print each result as a line of JSON when it is done");
  run->add_flag("--resume", options->resume,
                "Go on where an earlier run was interrupted: cases that it has done with the same inputs, version and "
                "proof are kept");
  run->add_option("--junit", options->junit, "Also write JUnit XML to this file");
  run->add_option("--baseline", options->baseline,
                  "Folder of earlier results: exit with 1 if a value moves by more than both its error bars, or a "
                  "verdict changes");
  add_store_options(*run, options->store);
  run->add_flag("--no-store", options->store.none, "Make all operators, and keep none");
  run->add_option("--distribute-from", options->distribute_from,
                  "Under mpirun: bodies of so many degrees of freedom or more are made by all ranks together")
      ->capture_default_str();
  run->callback([=, &command] { command = [=] { return run_cases(*options); }; });
}

void add_check(CLI::App& app, Command& command) {
  const auto options = std::make_shared<CheckOptions>();
  auto* check = app.add_subcommand(
      "check",
      "CI check: MDR against finite elements on small meshes, finite elements against exact solutions, the errors of "
      "the chosen settings against the tolerance, cases at the ends of every parameter, or random cases");
  add_check_options(*check, *options);
  check->callback([=, &command] { command = [=] { return run_check(*options); }; });
}

void add_report(CLI::App& app, Command& command) {
  const auto file = std::make_shared<std::string>();
  auto* report = app.add_subcommand("report", "One self-contained HTML page from the results in a folder");
  report->add_option("folder", *file, "Folder with results")->required();
  report->callback([=, &command] {
    command = [=] {
      fmt::print("{}\n", write_report(*file).string());
      return exit_agree;
    };
  });
}

void add_trust(CLI::App& app, Command& command) {
  const auto file = std::make_shared<std::string>();
  const auto options = std::make_shared<TrustOptions>();
  auto* trust = app.add_subcommand(
      "trust",
      "How far MDR can be trusted in a case, and why: its assumptions dropped one at a time, by finite elements");
  auto* trusted = trust->add_option("case", *file, "Case file (.prm or .json) with a single case");
  trust
      ->add_option("--map", options->map,
                   "Instead of a case: MDR's error over its maps, a CSV file; points that it has are kept")
      ->excludes(trusted);
  trust->add_option("-o,--output", options->output, "Folder for trust.json and a report of it");
  trust->add_flag("--json", options->json, "Print JSON");
  trust->add_option_function<std::string>(
      "--at-most", [=](const std::string& text) { options->at_most = share_of(text); },
      "Exit with 1 where a radius of MDR is off by more than this, as \"5 %\"");
  add_store_options(*trust, options->store);
  trust->add_flag("--no-store", options->store.none, "Make all operators, and keep none");
  trust->callback([=, &command] {
    if (file->empty() && options->map.empty()) throw CLI::RequiredError("case or --map");
    command = [=] { return options->map.empty() ? run_trust(*file, *options) : run_map(*options); };
  });
}

void add_trade(CLI::App& app, Command& command) {
  const auto file = std::make_shared<std::string>(), output = std::make_shared<std::string>("results");
  auto* trade = app.add_subcommand("trade", "The speed-accuracy front of a case; writes trade.json");
  trade->add_option("case", *file, "Case file (.prm or .json) with a single case")->required();
  trade->add_option("-o,--output", *output, "Folder for the results")->capture_default_str();
  trade->callback([=, &command] { command = [=] { return run_trade(*file, *output); }; });
}

void add_score(CLI::App& app, Command& command) {
  const auto file = std::make_shared<std::string>();
  const auto options = std::make_shared<ScoreOptions>();
  auto* score = app.add_subcommand("score", "The numbers of another code against a benchmark of docs/benchmarks.md");
  score->add_option("table", *file, "CSV of one row: names of quantities, their units, numbers")->required();
  score->add_option("--benchmark", options->benchmark, "Its name, as 10-elastic-60-degrees")->required();
  score
      ->add_option("--tolerance", options->tolerance,
                   "Exit with 1 where a number is farther off than this, radii over the contact radius")
      ->capture_default_str();
  score->add_flag("--json", options->json, "Print JSON");
  score->callback([=, &command] { command = [=] { return run_score(*file, *options); }; });
}

void add_store(CLI::App& app, Command& command) {
  const auto file = std::make_shared<std::string>();
  const auto options = std::make_shared<StoreOptions>();
  auto* store = app.add_subcommand("store", "The store of operators that runs have kept");
  store->add_option("action", *file, "list, verify (read all of it, exit with 1 if any is damaged) or clear")
      ->default_str("list")
      ->check(CLI::IsMember({"list", "verify", "clear"}));
  add_store_options(*store, *options);
  store->callback([=, &command] { command = [=] { return run_store(*file, *options); }; });
}

void add_pages(CLI::App& app, Command& command) {
  const auto file = std::make_shared<std::string>();
  auto* pages = app.add_subcommand("pages", "The manual page, or completion for a shell")->group("");
  pages->add_option("page", *file, "man or bash")->required()->check(CLI::IsMember({"man", "bash"}));
  pages->callback([=, &app, &command] {
    command = [=, &app] {
      fmt::print("{}", *file == "man" ? man_page(app) : bash_completion(app));
      return exit_agree;
    };
  });
}

void add_mesh(CLI::App& app, Command& command) {
  const auto file = std::make_shared<std::string>(), output = std::make_shared<std::string>();
  auto* mesh = app.add_subcommand("mesh", "The mesh of a case alone");
  mesh->add_option("case", *file, "Case file (.prm or .json)")->required();
  mesh->add_option("-o,--output", *output, "Mesh file (.msh)")->required();
  mesh->callback([=, &command] { command = [=] { return write_mesh(*file, *output); }; });
}

}  // namespace

void add_commands(CLI::App& app, Command& command) {
  app.fallthrough();  // also after the verb
  app.add_flag_callback("-q,--quiet", log::keep_quiet, "Warnings and errors alone, and what was asked for");
  app.add_flag_callback("-v,--verbose", log::say_details,
                        "Also what is refined and why, and which operators come from the store");
  for (const auto add : {add_new_case, add_explain, add_compare, add_mdr, add_run, add_check, add_report, add_trust,
                         add_trade, add_score, add_store, add_pages, add_mesh})
    add(app, command);
}

std::string unknown_verb(const CLI::App& app, const std::vector<std::string>& arguments) {
  const auto verb = std::find_if(arguments.begin(), arguments.end(),
                                 [](const std::string& argument) { return argument.rfind('-', 0) != 0; });
  if (verb == arguments.end()) return "";
  std::vector<std::string> verbs;
  for (const auto* known : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (known->get_name() == *verb) return "";
    if (!known->get_group().empty()) verbs.push_back(known->get_name());
  }
  return fmt::format("{}: no such verb{}; valid verbs: {}", *verb, did_you_mean(*verb, verbs), fmt::join(verbs, ", "));
}

std::string unknown_option(const CLI::App& app, const std::vector<std::string>& arguments) {
  const auto verbs = app.get_subcommands();  // those that were parsed
  if (verbs.empty()) return "";
  std::vector<std::string> options;
  for (const auto* known : {&app, static_cast<const CLI::App*>(verbs.front())})
    for (const auto* option : known->get_options())
      for (const auto& name : option->get_lnames()) options.push_back("--" + name);
  for (const auto& argument : arguments) {
    const auto name = argument.substr(0, argument.find('='));
    if (name.rfind("--", 0) != 0 || name == "--" || std::count(options.begin(), options.end(), name) > 0) continue;
    return fmt::format("{}: no such option of fretval {}{}; fretval {} --help lists them", name,
                       verbs.front()->get_name(), did_you_mean(name, options), verbs.front()->get_name());
  }
  return "";
}

}  // namespace fretval
