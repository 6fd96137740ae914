#include "comparison/command_line/score_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "comparison/case/case.h"
#include "comparison/command_line/exit_codes.h"
#include "comparison/command_line/trust_command.h"
#include "comparison/verification/benchmark_score.h"

namespace fretval {

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
