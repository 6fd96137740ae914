#include <fmt/format.h>

#include "comparison/verification/extremes/extreme_rows.h"

namespace fretval {
namespace {

Entries steady_normal(const Entries& entries) {
  return with(entries, {{"Motion / Normal amplitude", "0"}, {"Motion / Phase", "0"}});
}

Entries in_phase(const Entries& entries, double phase, double normal, double k) {
  return with(entries, {{"Motion / Phase", entry_text(phase)},
                        {"Motion / Normal amplitude", entry_text(normal * usual_indentation)},
                        {"Motion / Tangential amplitude", entry_text(0.75 * normal * usual_indentation / k)}});
}

void add_amplitudes(std::vector<ExtremeRow>& rows) {
  for (const double x : {1e-8, 1e-4, 1e-2, 0.1, 0.5, 0.9, 0.99, 0.9999, 1.0, 1.01, 2.0, 100.0})
    rows.push_back({"tangential amplitude over sliding", fmt::format("{:g}", x),
                    with_stick_ratio(with(extremes_base(), {{"Motion / Normal amplitude", "1e-5"}}), 0, x)});
  for (const double x : {1e-8, 1e-4, 1e-2, 0.1, 0.5, 0.9, 0.99, 0.999, 1.0, 1.1, 2.0, 10.0})
    rows.push_back({"normal amplitude, elastic", fmt::format("Dd/d0 = {:g}", x),
                    with(elastic_base(), {{"Motion / Normal amplitude", entry_text(x * usual_indentation)},
                                          {"Motion / Tangential amplitude", "7.5e-8"},
                                          {"Motion / Phase", "90"}})});
  for (const double x : {1e-8, 1e-2, 0.5, 0.9, 1.0, 2.0})
    rows.push_back({"normal amplitude, standard solid", fmt::format("Dd/d0 = {:g}", x),
                    with(extremes_base(), {{"Motion / Normal amplitude", entry_text(x * usual_indentation)},
                                           {"Motion / Tangential amplitude", "7.5e-7"}})});
}

void add_stick_zones(std::vector<ExtremeRow>& rows) {
  for (const double x : {0.1, 0.01, 1e-3, 1e-4})
    rows.push_back({"small stick zone", fmt::format("c/a = {:g}", x), with_stick_ratio(extremes_base(), x)});
  for (const double x : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6})
    rows.push_back({"narrow slip ring", fmt::format("1 - c/a = {:g}", x),
                    with_stick_ratio(steady_normal(extremes_base()), 1 - x)});
  rows.push_back({"border of no stick", "elastic", with_stick_ratio(elastic_base(), 0)});
  rows.push_back({"border of no stick", "elastic, 1e-9 below", with_stick_ratio(elastic_base(), 0, 1 - 1e-9)});
  rows.push_back({"border of no stick", "elastic, 1e-9 above", with_stick_ratio(elastic_base(), 0, 1 + 1e-9)});
  rows.push_back({"border of no stick", "steady normal force", with_stick_ratio(steady_normal(elastic_base()), 0)});
  rows.push_back({"border of no stick", "standard solid", with_stick_ratio(extremes_base(), 0)});
  rows.push_back({"all stick", "u_x0 = 0", with(extremes_base(), {{"Motion / Tangential amplitude", "0"}})});
  rows.push_back({"all stick", "u_x0 = 0, Dd = 0",
                  with(steady_normal(extremes_base()), {{"Motion / Tangential amplitude", "0"}})});
}

void add_phases(std::vector<ExtremeRow>& rows) {
  for (const double k : {0.5, 1 - 1e-9, 1.0, 1 + 1e-9, 2.0})
    rows.push_back({"in phase, elastic", fmt::format("phi0 = 0, k = {:.10g}", k), in_phase(elastic_base(), 0, 0.2, k)});
  for (const double k : {0.5, 1.0, 2.0})
    rows.push_back(
        {"in phase, standard solid", fmt::format("phi0 = 0, k = {:g}", k), in_phase(extremes_base(), 0, 0.2, k)});
  for (const double phase : {1e-6, 180.0, 360.0, -90.0, 1e6})
    rows.push_back({"phase at k = 1", fmt::format("phi0 = {:g} deg", phase), in_phase(elastic_base(), phase, 0.2, 1)});
  rows.push_back(
      {"phase at k = 1", "unlocked", with(in_phase(elastic_base(), 0, 0.2, 1), {{"Motion / Phase", "free"}})});
}

void add_frequencies(std::vector<ExtremeRow>& rows) {
  for (const double x : {1e-3, 1e-2, 0.5, 2.0, 1e2, 1e3}) {
    ExtremeRow row{"frequency ratio", fmt::format("f_x/f_z = {:g}", x),
                   with(in_phase(elastic_base(), 60, 0.2, 1), {{"Motion / Tangential frequency", entry_text(x)}})};
    row.refusal = "Motion / Tangential frequency";
    row.springs = true;
    rows.push_back(row);
  }
}

}  // namespace

std::vector<ExtremeRow> extreme_motion_rows() {
  std::vector<ExtremeRow> rows;
  add_amplitudes(rows);
  add_stick_zones(rows);
  add_phases(rows);
  add_frequencies(rows);
  return rows;
}

}  // namespace fretval
