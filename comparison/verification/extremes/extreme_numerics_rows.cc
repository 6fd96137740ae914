#include <fmt/format.h>

#include "comparison/verification/extremes/extreme_rows.h"

namespace fretval {
namespace {

ExtremeRow cycles_row(int n_cycles, const Entries& entries) {
  ExtremeRow row{"cycles", fmt::format("{} at least", n_cycles), entries};
  row.ramp_cycles = n_cycles;
  return row;
}

ExtremeRow refused(const char* family, const std::string& value, const Entries& entries, const char* words) {
  return {family, value, entries, words};
}

}  // namespace

std::vector<ExtremeRow> extreme_numerics_rows() {
  std::vector<ExtremeRow> rows;
  for (const char* n : {"4", "15"})
    rows.push_back(refused("steps per cycle", n, with(extremes_base(), {{"Accuracy / Steps per cycle", n}}),
                           "Accuracy / Steps per cycle"));
  for (const int n : {16, 36, 100, 10000})
    rows.push_back({"steps per cycle", fmt::format("{}", n),
                    with(extremes_base(), {{"Accuracy / Steps per cycle", fmt::format("{}", n)}})});
  for (const int n : {1, 10, 100}) rows.push_back(cycles_row(n, extremes_base()));
  // An elastic body takes fewer computations for its error budget.
  const auto elastic = with(elastic_base(), {{"Accuracy / Steps per cycle", "20"}});
  for (const int n : {1000, 10000}) rows.push_back(cycles_row(n, elastic));
  for (const char* n : {"4", "15"})
    rows.push_back(refused("rings per radius", n, with(extremes_base(), {{"Accuracy / Rings per radius", n}}),
                           "Accuracy / Rings per radius"));
  for (const int n : {16, 32, 128})
    rows.push_back({"rings per radius", fmt::format("{}", n),
                    with(extremes_base(), {{"Accuracy / Rings per radius", fmt::format("{}", n)}})});
  return rows;
}

std::vector<ExtremeRow> extreme_bad_input_rows() {
  const auto changed = [](const char* place, const char* value) { return with(extremes_base(), {{place, value}}); };
  const auto row = [&](const char* place, const char* value) {
    return refused("refused input", std::string(place) + " = " + value, changed(place, value), place);
  };
  return {row("Elastomer / Relaxed shear modulus", "0"),
          row("Friction / Coefficient", "0"),
          row("Motion / Indentation", "0"),
          row("Motion / Normal frequency", "inf"),
          row("Motion / Tangential amplitude", "nan"),
          row("Accuracy / Tolerance", "1e-9")};
}

}  // namespace fretval
