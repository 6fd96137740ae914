#include "comparison/verification/extremes/extreme_suite.h"

#include "comparison/verification/extremes/extreme_springs.h"

namespace fretval {
namespace {

void compute_at_least(int n_cycles, PreparedCase& prepared) {
  auto resolution = prepared.fem.resolution;
  resolution.n_ramp_cycles = n_cycles;
  prepared.fem = at_resolution(std::move(prepared.fem), resolution);
}

/// The folder of the measured profiles is another one on every machine.
void leave_out_folder(std::string& text) {
  const std::string folder = std::string(FRETVAL_EXTREMES_CASES) + "/";
  const auto place = text.find(folder);
  if (place != std::string::npos) text.erase(place, folder.size());
}

}  // namespace

std::vector<SuiteCase> extreme_cases(const std::vector<ExtremeRow>& rows) {
  std::vector<SuiteCase> cases;
  for (const auto& row : rows) {
    SuiteCase one{row.family, row.value, case_text(row.entries), row.refusal};
    if (row.springs) one.second_way = compared_with_springs;
    if (row.ramp_cycles) one.change = [n = *row.ramp_cycles](PreparedCase& p) { compute_at_least(n, p); };
    cases.push_back(std::move(one));
  }
  return cases;
}

SuiteRun run_extreme_suite(const std::vector<ExtremeRow>& rows) {
  auto run =
      run_suite("extremes", "Every parameter to its ends, along families of several values.", extreme_cases(rows));
  for (auto& row : run.rows) {
    leave_out_folder(row.asked.text);
    leave_out_folder(row.refusal);
  }
  return run;
}

}  // namespace fretval
