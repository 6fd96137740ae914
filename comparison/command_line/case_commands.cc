#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "comparison/accuracy/prepared_case.h"
#include "comparison/case/case.h"
#include "comparison/case/plausibility.h"
#include "comparison/case_file/case_file.h"
#include "comparison/case_file/entry_lookup.h"
#include "comparison/command_line/ending.h"
#include "comparison/command_line/verbs.h"
#include "comparison/reference/mdr_case.h"
#include "comparison/report/sections/sections.h"
#include "comparison/results/changes.h"
#include "comparison/run/explanation.h"
#include "comparison/support/files.h"
#include "comparison/support/log.h"
#include "comparison/support/stopwatch.h"
#include "comparison/verification/benchmark_score.h"
#include "comparison/verification/trade/trade.h"
#include "fem/condensation/petsc_session.h"

namespace fretval {

namespace fs = std::filesystem;

int write_new_case(const fs::path& file, const NewCase& choice) {
  if (file.extension() != ".prm" || file.stem().empty())
    throw InputError(fmt::format("{}: expected the name of a case file, NAME.prm", file.string()));
  const auto files = new_case_files(file.stem().string(), choice);
  const auto folder = file.parent_path();
  for (const auto& [name, text] : files)
    if (fs::exists(folder / name))
      throw InputError(fmt::format("{}: is there already; expected another name", (folder / name).string()));
  if (!folder.empty()) fs::create_directories(folder);
  for (const auto& [name, text] : files) {
    write_file(folder / name, text);
    fmt::print("{}\n", (folder / name).string());
  }
  return exit_agree;
}

int explain_case(const std::string& file) {
  const auto cases = read_case_file(file, Accuracy::optional);
  const auto& input = cases.front();
  for (const auto& warning : input.warnings) log::warn(warning);
  for (const auto& warning : implausible_values(input, any_profile_of(input.indenter))) log::warn(warning);
  fmt::print("{}", explanation(cases.front(), cases));
  if (cases.front().sweep)
    fmt::print("  {:<13}{} cases over {}; this is the first of them\n", "sweep", cases.size(),
               cases.front().sweep->entry);
  return exit_agree;
}

int print_entries() {
  fmt::print("{}", entries_reference());
  return exit_agree;
}

int compare_results(const fs::path& before, const fs::path& after) {
  const auto changes = changes_between(read_results(before), read_results(after));
  if (changes.values.empty())
    throw InputError(fmt::format("{}, {}: have no case in common; a case has the name of its file", before.string(),
                                 after.string()));
  fmt::print("{}", changes_text(changes));
  return changes.any() ? exit_disagree : exit_agree;
}

int run_trade(const std::string& file, const fs::path& output) {
  Stopwatch watch;
  const auto cases = read_case_file(file);
  if (cases.size() != 1)
    throw InputError(fmt::format("{}: a sweep has many trades; expected a file with a single case", file));
  const auto prepared = prepare(cases).front();
  if (prepared.mdr.has_forces())
    throw InputError(
        fmt::format("{}: Motion: a force is prescribed; the levels of a trade need prescribed displacements", file));
  if (prepared.mdr.path)
    throw InputError(fmt::format("{}: Motion / Path: the levels of a trade need oscillations", file));
  for (const auto& warning : prepared.input.warnings) log::warn_once(warning);
  const fs::path folder = output / prepared.input.name;
  fs::create_directories(folder);
  const fem::PetscSession session;
  const auto plan = trade_plan(prepared.fem);
  const auto levels = computed_levels(prepared, plan);
  const auto json = trade_json(prepared, plan, levels);
  write_file(folder / "trade.json", json.dump(2) + "\n");
  fmt::print("{}", trade_text(json));
  log::info(fmt::format("{} settings in {:.1f} s: {}", levels.size(), watch.lap(), (folder / "trade.json").string()));
  return json.at("front").empty() ? exit_numerics_failed : exit_agree;
}

int run_score(const std::string& file, const ScoreOptions& options) {
  const double tolerance = share_of(options.tolerance, "--tolerance");
  std::ifstream stream(file);
  if (!stream) throw InputError(fmt::format("{}: cannot be read; expected a table of one row", file));
  const auto rows = benchmark_score(options.benchmark, read_foreign_answer(stream, file), tolerance);
  if (options.json)
    fmt::print("{}\n", score_json(options.benchmark, rows, tolerance).dump(2));
  else
    fmt::print("{}", score_text(options.benchmark, rows, tolerance));
  return std::all_of(rows.begin(), rows.end(), [](const ScoreRow& row) { return row.agrees; }) ? exit_agree
                                                                                               : exit_disagree;
}

}  // namespace fretval
