#include "comparison/command_line/run_command.h"

#include <fmt/format.h>

#include <algorithm>

#include "comparison/accuracy/wear_proof.h"
#include "comparison/case/case_file.h"
#include "comparison/command_line/exit_codes.h"
#include "comparison/command_line/terminal.h"
#include "comparison/report/report.h"
#include "comparison/results/batch.h"
#include "comparison/support/folder_lock.h"
#include "comparison/support/log.h"
#include "comparison/support/stopwatch.h"
#include "fem/condensation/petsc_session.h"

namespace fretval {
namespace {

std::vector<Case> read_cases(const std::vector<std::string>& files) {
  std::vector<Case> cases;
  for (const auto& file : files)
    for (auto& input : read_case_file(file)) cases.push_back(std::move(input));
  return cases;
}

int exit_code_of(const std::vector<BatchLine>& lines) {
  const auto failed = [](const BatchLine& line) { return !line.failure.empty(); };
  if (std::any_of(lines.begin(), lines.end(), failed)) return exit_numerics_failed;
  const auto agrees = [](const BatchLine& line) { return line.pass; };
  return std::all_of(lines.begin(), lines.end(), agrees) ? exit_agree : exit_disagree;
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

}  // namespace

int run_cases(const std::vector<std::string>& files, const std::filesystem::path& output, Proof proof) {
  Stopwatch watch;
  const auto prepared = prepare(read_cases(files));
  for (const auto& one : prepared)
    for (const auto& warning : one.input.warnings) log::warn(warning);
  log_left_out(prepared);
  const FolderLock lock(output);
  const fem::PetscSession session;
  Progress progress;
  const auto lines =
      run_batch(prepared, {proof, {}, output, [&](const BatchLine& line, std::size_t n_done, std::size_t n_cases) {
                             progress.show(line, n_done, n_cases);
                           }});
  lines.size() == 1 && lines[0].failure.empty() ? print_answer(lines[0]) : print_verdicts(lines);
  if (std::any_of(lines.begin(), lines.end(), [](const BatchLine& line) { return line.failure.empty(); }))
    log::info(fmt::format("report: {}", write_report(output).string()));
  log::info(fmt::format("{} cases in {:.1f} s", lines.size(), watch.lap()));
  return exit_code_of(lines);
}

}  // namespace fretval
