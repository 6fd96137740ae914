#include "comparison/command_line/case_commands.h"

#include <fmt/format.h>

#include "comparison/case/plausibility.h"
#include "comparison/case_file/case_file.h"
#include "comparison/case_file/entry_lookup.h"
#include "comparison/command_line/exit_codes.h"
#include "comparison/reference/mdr_case.h"
#include "comparison/results/changes.h"
#include "comparison/run/explanation.h"
#include "comparison/support/files.h"
#include "comparison/support/log.h"

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

}  // namespace fretval
