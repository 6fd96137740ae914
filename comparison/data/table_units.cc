#include "comparison/data/table_units.h"

#include <fmt/format.h>

#include <fstream>

#include "mdr/support/csv_units.h"

namespace fretval {

const std::vector<mdr::ColumnKind>& rig_columns() {
  static const std::vector<mdr::ColumnKind> kinds{
      {"time", {"t", "time*", "zeit*"}, mdr::time_units()},
      {"indentation d",
       {"d", "indentation*", "depth", "uz", "z", "eindringung*", "eindringtiefe", "normaldisp*", "normalweg"},
       mdr::length_units()},
      {"tangential displacement u_x",
       {"ux", "x", "displacement", "disp", "tangentialdisp*", "stroke", "weg", "lateraldisp*", "slide"},
       mdr::length_units()},
      {"normal force F_N", {"fn", "fz", "n", "normalforce", "normalkraft", "normalload", "load"}, mdr::force_units()},
      {"tangential force F_x",
       {"fx", "ft", "q", "tangentialforce", "frictionforce", "lateralforce", "reibkraft", "tangentialkraft"},
       mdr::force_units()}};
  return kinds;
}

std::string skipped_text(const std::string& file, const mdr::ChosenColumns& chosen) {
  return chosen.skipped.empty() ? "" : fmt::format("{}: skipped: {}", file, chosen.skipped);
}

void take_into_si(const std::string& file, const std::vector<mdr::WantedColumn>& wanted, mdr::ChosenColumns& chosen) {
  for (std::size_t column = 0; column < wanted.size(); ++column) {
    if (!chosen.kind[column]) continue;
    const double size = mdr::unit_of_column(chosen.csv, column, wanted[column].kinds[*chosen.kind[column]].units, file);
    for (double& value : chosen.csv.columns[column]) value *= size;
  }
}

std::string require_units(const std::string& file, const std::vector<mdr::WantedColumn>& wanted) {
  const char* const example = wanted.size() == 2 ? "\"r,f\" and \"mm,um\"" : "\"f,G',G''\" and \"Hz,MPa,MPa\"";
  return input_from(file, [&] {
    std::ifstream stream(file);
    const auto chosen = mdr::read_columns(stream, file, wanted, mdr::InOrder::yes);
    for (std::size_t column = 0; column < wanted.size(); ++column) {
      const auto& kinds = wanted[column].kinds;
      const bool is_ratio = kinds[chosen.kind[column].value_or(0)].units.count("") > 0;
      if (!names_unit(chosen.csv, column) && !is_ratio)
        throw InputError(
            fmt::format("{}: column {} has no unit; must begin with a line of names and one of units, for example {}",
                        file, column + 1, example));
    }
    return skipped_text(file, chosen);
  });
}

}  // namespace fretval
