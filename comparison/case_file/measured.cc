#include "comparison/case_file/measured.h"

#include <fmt/format.h>

#include <fstream>

#include "comparison/data/table_units.h"
#include "mdr/support/csv_units.h"

namespace fretval {
namespace {

const char* const measured_section = "Measured";

const std::vector<mdr::WantedColumn>& loop_columns() {
  static const std::vector<mdr::WantedColumn> wanted{
      {{{"time", {"t", "time*", "zeit*"}, mdr::time_units()}}, true},
      {{{"indentation d",
         {"d", "indentation*", "depth", "uz", "z", "eindringtiefe", "normaldisp*", "normalweg"},
         mdr::length_units()}},
       true},
      {{{"tangential displacement u_x",
         {"ux", "x", "displacement", "disp", "tangentialdisp*", "stroke", "weg", "lateraldisp*", "slide"},
         mdr::length_units()}},
       true},
      {{{"normal force F_N",
         {"fn", "fz", "n", "normalforce", "normalkraft", "normalload", "load"},
         mdr::force_units()}},
       true},
      {{{"tangential force F_x",
         {"fx", "ft", "q", "tangentialforce", "frictionforce", "lateralforce", "reibkraft", "tangentialkraft"},
         mdr::force_units()}},
       true}};
  return wanted;
}

void read_loops(const std::string& file, Case::Measured& measured, std::vector<std::string>& notes) {
  try {
    std::ifstream stream(file);
    auto chosen = mdr::read_columns(stream, file, loop_columns(), mdr::InOrder::no);
    auto& csv = chosen.csv;
    for (std::size_t k = 0; k < csv.columns.size(); ++k) {
      if (!chosen.kind[k]) continue;
      if (!mdr::names_unit(csv, k))
        throw InputError(
            fmt::format("{}: column {} has no unit; must have one, for example \"F_x [N]\"", file, csv.names[k]));
      const double size = mdr::unit_of_column(csv, k, loop_columns()[k].kinds[0].units, file);
      for (double& value : csv.columns[k]) value *= size;
    }
    if (!chosen.kind[3] && !chosen.kind[4])
      throw InputError(
          fmt::format("{}: has neither a column F_N nor a column F_x with a unit; must have one of them", file));
    if (!chosen.kind[0] && !chosen.kind[1] && !chosen.kind[2])
      throw InputError(
          fmt::format("{}: has neither t nor d nor u_x with a unit, over which the forces would be drawn", file));
    if (auto skipped = skipped_text(file, chosen); !skipped.empty()) notes.push_back(std::move(skipped));
    measured.loop = file;
    measured.time = std::move(csv.columns[0]);
    measured.indentation = std::move(csv.columns[1]);
    measured.tangential_displacement = std::move(csv.columns[2]);
    measured.normal_force = std::move(csv.columns[3]);
    measured.tangential_force = std::move(csv.columns[4]);
  } catch (const std::invalid_argument& error) {
    throw InputError(error.what());
  }
}

std::optional<Case::Measured::Value> read_value(const EntryReader& entries, const std::string& name) {
  const auto uncertainty = name + " uncertainty";
  if (!entries.given(measured_section, name)) {
    entries.forbid(measured_section, uncertainty, "it belongs to a " + name);
    return std::nullopt;
  }
  return Case::Measured::Value{entries.number(measured_section, name), entries.number(measured_section, uncertainty)};
}

}  // namespace

std::optional<Case::Measured> read_measured(const EntryReader& entries, std::vector<std::string>& notes) {
  Case::Measured measured;
  measured.stick_radius = read_value(entries, "Stick radius");
  measured.contact_radius = read_value(entries, "Contact radius");
  if (entries.given(measured_section, "Loops")) {
    const auto file = entries.path(measured_section, "Loops");
    try {
      if (!file.empty()) read_loops(file, measured, notes);
    } catch (const InputError& error) {
      entries.add_problem(error.what());
    }
  }
  if (!measured.stick_radius && !measured.contact_radius && measured.loop.empty()) return std::nullopt;
  return measured;
}

}  // namespace fretval
