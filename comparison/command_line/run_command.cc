#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <sstream>

#include "comparison/accuracy/wear_proof.h"
#include "comparison/case_file/case_file.h"
#include "comparison/case_file/entry_lookup.h"
#include "comparison/command_line/ending.h"
#include "comparison/command_line/terminal.h"
#include "comparison/command_line/verbs.h"
#include "comparison/report/report.h"
#include "comparison/report/text/numbers.h"
#include "comparison/results/changes.h"
#include "comparison/results/data_text.h"
#include "comparison/run/batch.h"
#include "comparison/run/estimate.h"
#include "comparison/run/sweep_line.h"
#include "comparison/support/files.h"
#include "comparison/support/folders.h"
#include "comparison/support/junit.h"
#include "comparison/support/log.h"
#include "comparison/support/parallel.h"
#include "comparison/support/progress.h"
#include "comparison/support/ranks.h"
#include "comparison/support/stopwatch.h"
#include "fem/condensation/petsc_session.h"

namespace fretval {
namespace {

namespace fs = std::filesystem;

/// The case files of a folder in the order of their names; a file is itself.
std::vector<fs::path> case_files(const fs::path& input) {
  if (!fs::is_directory(input)) return {input};
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(input))
    if (entry.path().extension() == ".prm" || entry.path().extension() == ".json") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  if (files.empty()) throw InputError(fmt::format("{}: the folder has no case files (.prm or .json)", input.string()));
  return files;
}

/// Says what is wrong with any of them.
std::vector<Case> read_cases(const std::vector<std::string>& inputs) {
  std::vector<Case> cases;
  Problems problems;
  for (const auto& input : inputs)
    for (const auto& file : case_files(input)) try {
        for (auto& one : read_case_file(file)) cases.push_back(std::move(one));
      } catch (const InputError& error) {
        problems.add(error.what());
      }
  problems.throw_if_any();
  return cases;
}

int exit_code_of(const std::vector<BatchLine>& lines) {
  const auto any = [&](Outcome outcome) {
    return std::any_of(lines.begin(), lines.end(), [=](const BatchLine& line) { return line.outcome == outcome; });
  };
  if (std::any_of(lines.begin(), lines.end(), [](const BatchLine& line) { return line.failed(); }))
    return exit_numerics_failed;
  if (any(Outcome::disagree)) return exit_disagree;
  return any(Outcome::not_resolved) ? exit_not_resolved : exit_agree;
}

/// Message for a run that is interrupted after some results.
std::string interrupted_text(const std::vector<PreparedCase>& prepared, const fs::path& output, std::size_t n_kept) {
  const auto wear =
      std::any_of(prepared.begin(), prepared.end(), wears) ? "; wear goes on from here when it is run again" : "";
  if (n_kept == 0) return fmt::format("interrupted: no case is done{}", wear);
  return fmt::format("interrupted: {0} of {1} kept in {2}; fretval report {2} shows what is there{3}", n_kept,
                     counted(prepared.size(), "case"), output.string(), wear);
}

std::vector<BatchLine> computed_lines(const std::vector<PreparedCase>& prepared, const RunOptions& options,
                                      const Ranks& ranks, BesideCases beside) {
  const fem::PetscSession session;
  Progress progress(prepared.size(),
                    estimated_seconds(prepared, options.proof, n_cores() * static_cast<std::size_t>(ranks.count())));
  std::size_t n_kept = 0;
  const auto told = [&](const BatchLine& line) {
    if (line.failure.empty()) ++n_kept;
    if (!options.output.empty()) say_on_interrupt(interrupted_text(prepared, options.output, n_kept));
    progress.done(outcome_text(line), !line.failed() && passes(line.outcome), line.name);
    if (options.json && line.failure.empty()) print_line(line.json);
  };
  const auto under_way = [&](const std::string& name, double share, const std::string& what) {
    progress.under_way(name, share, what);
  };
  BodyStore bodies(store_of(options.store));
  const BatchOptions batch{options.proof, options.output, told, under_way, std::move(beside)};
  auto lines = ranks.are_several()
                   ? run_ranked_batch(prepared, batch, bodies, ranks, options.distribute_from, end_with_failure)
                   : run_batch(prepared, batch, bodies);
  const auto n = ranks.sum({bodies.n_made, bodies.n_kept});
  if (bodies.operators && ranks.is_first())
    log::detail(fmt::format("{} bodies made, {} from the store {}", n[0], n[1], bodies.operators->folder().string()));
  return lines;
}

/// changes: from a baseline; null: there is none.
std::string junit_of(const std::vector<BatchLine>& lines, const Changes* changes) {
  std::vector<JUnitCase> cases;
  for (const auto& line : lines) {
    // What happens comes first, in a line of its own, then the verdict.
    const auto verdict = line.answer.substr(std::min(line.answer.size(), line.answer.find('\n') + 1));
    auto why = line.failed() || passes(line.outcome) ? std::string() : verdict.substr(0, verdict.find('\n'));
    const auto changed = changes ? changes->of_case(line.name) : std::string();
    if (!changed.empty())
      why += (why.empty() ? "" : "\n") + ("other than the baseline, beyond the bars of both:\n" + changed);
    cases.push_back({line.name, why, line.answer, line.seconds, line.failure});
  }
  return junit_document("fretval run", cases);
}

/// The results of these cases in a baseline. One that has none of them is no baseline: nothing could depart from it.
std::vector<StoredResult> baseline_of(const fs::path& folder, const std::vector<PreparedCase>& prepared) {
  std::set<std::string> names;
  for (const auto& one : prepared) names.insert(one.input.name);
  std::vector<StoredResult> baseline;
  for (auto& result : read_results(folder))
    if (names.erase(result.name()) > 0) baseline.push_back(std::move(result));
  if (baseline.empty())
    throw InputError(fmt::format("--baseline {}: has none of the cases; expected results of the same names, as {}",
                                 folder.string(), prepared.front().input.name));
  for (const auto& name : names) log::warn(fmt::format("--baseline {}: has no {}", folder.string(), name));
  return baseline;
}

/// Says what has changed; as a warning, if anything has but for values within their bars.
Changes changes_from(const std::vector<StoredResult>& baseline, const std::vector<BatchLine>& lines) {
  std::vector<StoredResult> results;
  for (const auto& line : lines)
    if (line.failure.empty()) results.push_back({nlohmann::ordered_json::parse(line.json), {}});
  auto changes = changes_between(baseline, results);
  std::istringstream text(changes_text(changes));
  for (std::string line; std::getline(text, line);)
    changes.any() ? log::warn("baseline: " + line) : log::info("baseline: " + line);
  return changes;
}

/// Says what the cases do not need, and so is not computed.
void log_left_out(const std::vector<PreparedCase>& prepared) {
  std::map<std::string, int> counts;
  for (const auto& one : prepared) {
    for (const auto& words : left_out(one.fem)) ++counts[words];
    if (one.input.wear_kinetics && !wears(one)) ++counts["no tangential motion: nothing slips, nothing wears"];
  }
  for (const auto& [words, n] : counts) log::info(fmt::format("{} of {} cases: {}", n, prepared.size(), words));
}

std::set<std::string> names_of(const std::vector<Case>& cases) {
  std::set<std::string> names;
  for (const auto& one : cases) names.insert(one.name);
  return names;
}

/// Says that an output has results of other cases, as of a sweep that had other values, which the report shows as well.
void log_others(const fs::path& output, const std::vector<Case>& cases) {
  const auto names = names_of(cases);
  std::set<std::string> others;
  for (const auto& entry : fs::recursive_directory_iterator(output)) {
    const auto name = entry.path().parent_path().lexically_relative(output).generic_string();
    if (entry.path().filename() == "result.json" && names.count(name) == 0) others.insert(name);
  }
  if (!others.empty())
    log::info(fmt::format("{}: has {} of earlier runs as well, which the report shows, too: {}{}", output.string(),
                          counted(others.size(), "result"), *others.begin(), others.size() > 1 ? ", …" : ""));
}

/// What an earlier run has written of each case; empty: it is to be computed.
using KeptLines = std::vector<std::optional<BatchLine>>;

KeptLines kept_lines(const std::vector<PreparedCase>& prepared, const RunOptions& options, const Ranks& ranks) {
  KeptLines kept(prepared.size());
  if (!options.resume) return kept;
  if (ranks.are_several())
    throw InputError("--resume: all ranks have to know the same cases; expected one process, or no --resume");
  std::size_t n = 0;
  for (std::size_t i = 0; i < prepared.size(); ++i) {
    kept[i] = kept_line(prepared[i], options.proof, options.output);
    n += kept[i] ? 1 : 0;
  }
  log::info(
      fmt::format("{}: {} of {} kept of an earlier run", options.output.string(), n, counted(prepared.size(), "case")));
  return kept;
}

std::vector<PreparedCase> not_kept(const std::vector<PreparedCase>& prepared, const KeptLines& kept) {
  std::vector<PreparedCase> open;
  for (std::size_t i = 0; i < prepared.size(); ++i)
    if (!kept[i]) open.push_back(prepared[i]);
  return open;
}

/// Kept and computed lines together, in the order of the cases.
std::vector<BatchLine> all_lines(KeptLines kept, std::vector<BatchLine> computed) {
  std::vector<BatchLine> lines;
  std::size_t next = 0;
  for (auto& one : kept) lines.push_back(one ? std::move(*one) : std::move(computed.at(next++)));
  return lines;
}

}  // namespace

void prepare_output_file(const char* option, const std::string& file) {
  if (fs::is_directory(file))
    throw InputError(fmt::format("{}: is a folder; {} expects the name of a file", file, option));
  if (const auto folder = fs::path(file).parent_path(); !folder.empty()) fs::create_directories(folder);
}

int run_cases(const RunOptions& options) {
  Stopwatch watch;
  const Ranks ranks;
  const auto& output = options.output;
  const auto cases = read_cases(options.inputs);
  const auto prepared = prepare(cases);
  const bool keeps_results = !output.empty();
  SweepLines sweep_lines(keeps_results ? cases : std::vector<Case>());
  if (!ranks.is_first()) {
    computed_lines(prepared, options, ranks, sweep_lines.work());
    return exit_agree;
  }
  const auto baseline =
      options.baseline.empty() ? std::vector<StoredResult>{} : baseline_of(options.baseline, prepared);
  prepare_output_file("--junit", options.junit);
  for (const auto& one : prepared) {
    for (const auto& note : one.input.notes) log::info_once(note);
    if (const auto text = duration_text(one.input); !text.empty()) log::info(text);
    for (const auto& warning : one.input.warnings) log::warn_once(warning);
  }
  log_left_out(prepared);
  sweep_lines.log_costs();
  if (keeps_results) say_on_interrupt(interrupted_text(prepared, output, 0));
  const auto lock = keeps_results ? std::make_unique<FolderLock>(output) : nullptr;
  if (keeps_results) log_others(output, cases);
  auto kept = kept_lines(prepared, options, ranks);
  auto computed = computed_lines(not_kept(prepared, kept), options, ranks, sweep_lines.work());
  const auto lines = all_lines(std::move(kept), std::move(computed));
  if (!options.json) lines.size() == 1 && lines[0].failure.empty() ? print_answer(lines[0]) : print_verdicts(lines);
  if (keeps_results) sweep_lines.write(output, lines);
  if (keeps_results &&
      std::any_of(lines.begin(), lines.end(), [](const BatchLine& line) { return line.failure.empty(); }))
    log::info(fmt::format("report: {}", write_report(output, names_of(cases)).string()));
  log::info(fmt::format("{} in {:.1f} s", counted(lines.size(), "case"), watch.lap()));
  const auto changes = baseline.empty() ? std::nullopt : std::optional(changes_from(baseline, lines));
  if (!options.junit.empty()) write_file(options.junit, junit_of(lines, changes ? &*changes : nullptr));
  const int exit_code = exit_code_of(lines);
  const bool may_change = exit_code == exit_agree || exit_code == exit_not_resolved;
  return may_change && changes && changes->any() ? exit_disagree : exit_code;
}

}  // namespace fretval
