#include "comparison/command_line/trade_command.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "comparison/accuracy/prepared_case.h"
#include "comparison/case_file/case_file.h"
#include "comparison/command_line/exit_codes.h"
#include "comparison/report/sections/trade_section.h"
#include "comparison/support/files.h"
#include "comparison/support/log.h"
#include "comparison/support/stopwatch.h"
#include "comparison/verification/trade/trade.h"
#include "fem/condensation/petsc_session.h"

namespace fretval {

namespace fs = std::filesystem;

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

}  // namespace fretval
