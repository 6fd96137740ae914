#include "comparison/data/branches_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <numeric>
#include <regex>
#include <sstream>

#include "comparison/data/table_units.h"
#include "mdr/support/csv_units.h"
#include "mdr/support/trimmed.h"

namespace fretval {
namespace {

using mdr::TextLine;

/// Modulus of a table over the shear modulus: 2 (1 + nu) for Young's moduli, otherwise 1.
double size_of(bool youngs, double poisson_ratio) {
  return youngs ? 2 * (1 + poisson_ratio) : 1;
}

std::string upper_without_blanks(const std::string& text) {
  std::string upper;
  for (const char c : text)
    if (c != ' ' && c != '\t') upper += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return upper;
}

void require_known_ratio(const std::string& file, const std::vector<double>& ratios) {
  double sum = 0;
  for (const double ratio : ratios) {
    if (!(ratio > 0 && ratio < 1))
      throw InputError(
          fmt::format("{}: a ratio of {:g} to the instantaneous modulus; must be above 0 and below 1", file, ratio));
    sum += ratio;
  }
  if (sum >= 1)
    throw InputError(
        fmt::format("{}: the ratios to the instantaneous modulus add up to {:.6g}; must be below 1: a body "
                    "that relaxes to nothing has no permanent stick",
                    file, sum));
}

// Abaqus.

bool is_abaqus(const std::vector<TextLine>& lines) {
  return std::any_of(lines.begin(), lines.end(), [](const TextLine& line) {
    return upper_without_blanks(line.text).rfind("*VISCOELASTIC", 0) == 0;
  });
}

/// A blank is 0.
std::vector<double> numbers_of(const std::string& file, const TextLine& line) {
  std::vector<double> values;
  mdr::NumberReader reader(file);
  auto fields = mdr::split_fields(line.text).values;
  while (!fields.empty() && fields.back().empty()) fields.pop_back();
  for (const auto& field : fields) values.push_back(field.empty() ? 0 : reader.read(line, field));
  return values;
}

void read_abaqus_row(const std::string& file, const TextLine& line, PronySeries& series) {
  const auto values = numbers_of(file, line);
  if (values.size() != 3)
    mdr::fail_at(file, line, fmt::format("has {} values; must have three, g_i, k_i, tau_i", values.size()));
  const auto i = series.ratios.size() + 1;
  if (values[1] != 0)
    mdr::fail_at(file, line,
                 fmt::format("k_{} = {:g}: the bulk modulus relaxes, which is not computed; must be 0", i, values[1]));
  if (!(values[2] > 0)) mdr::fail_at(file, line, fmt::format("tau_{} = {:g}: must be positive", i, values[2]));
  series.ratios.push_back(values[0]);
  series.times.push_back(values[2]);
}

void read_abaqus_modulus(const std::string& file, const TextLine& line, bool instantaneous, PronySeries& series) {
  const auto values = numbers_of(file, line);
  if (values.size() < 2) mdr::fail_at(file, line, "must have Young's modulus and Poisson's ratio");
  const double shear = values[0] / (2 * (1 + values[1]));
  (instantaneous ? series.instantaneous : series.relaxed) = shear;
  series.notes =
      fmt::format("{}: *ELASTIC has E = {:g} with nu = {:g} as the {} modulus, taken to be in Pa, so G = {:.6g} Pa",
                  file, values[0], values[1], instantaneous ? "instantaneous" : "long-term", shear);
}

PronySeries read_abaqus(const std::string& file, const std::vector<TextLine>& lines) {
  enum class Part { other, prony, elastic } part = Part::other;
  bool instantaneous = false;
  PronySeries series;
  for (const auto& line : lines) {
    const auto text = upper_without_blanks(line.text);
    if (text.empty() || text.rfind("**", 0) == 0) continue;
    if (text.front() == '*') {
      part = Part::other;
      if (text.rfind("*VISCOELASTIC", 0) == 0) {
        if (text.find("TIME=PRONY") == std::string::npos) mdr::fail_at(file, line, "must be *VISCOELASTIC, TIME=PRONY");
        part = Part::prony;
      } else if (text.rfind("*ELASTIC", 0) == 0) {
        part = Part::elastic;
        instantaneous = text.find("MODULI=INSTANTANEOUS") != std::string::npos;
      }
    } else if (part == Part::prony) {
      read_abaqus_row(file, line, series);
    } else if (part == Part::elastic) {
      read_abaqus_modulus(file, line, instantaneous, series);
      part = Part::other;
    }
  }
  if (series.ratios.empty()) throw InputError(fmt::format("{}: *VISCOELASTIC has no rows g_i, k_i, tau_i", file));
  return series;
}

// Tables.

/// A modulus that a line of its own names, "# E0 [MPa]: 12" or "G_inf = 3 MPa".
struct NamedModulus {
  bool youngs, relaxed;
  double value;
};

std::optional<NamedModulus> named_modulus(const std::string& file, const TextLine& line) {
  static const std::regex form(
      "^[#\\s]*([EG])_?(0|inst|inf|infty|\u221e)\\s*(?:[\\[(]\\s*([^\\])]*?)\\s*[\\])])?\\s*[=:;,\\t ]\\s*"
      "([-+0-9.,eE]*[0-9.])\\s*[;,]?\\s*[\\[(]?([A-Za-z/^0-9\u00b2]*)[\\])]?\\s*[;,]*\\s*$");
  std::smatch part;
  if (!std::regex_match(line.text, part, form)) return std::nullopt;
  const auto unit = part[3].matched && part[3].length() > 0 ? part[3].str() : part[5].str();
  const auto size = mdr::modulus_units().find(unit);
  if (size == mdr::modulus_units().end())
    mdr::fail_at(file, line, fmt::format("unit \"{}\" of a modulus; must be Pa, kPa, MPa, GPa or N/mm^2", unit));
  mdr::NumberReader reader(file);
  reader.begin_row(line, {{}, ';'});
  const double value = reader.read(line, part[4].str()) * size->second;
  if (!(value > 0)) mdr::fail_at(file, line, "a modulus must be positive");
  const auto index = part[2].str();
  return NamedModulus{part[1].str() == "E", index != "0" && index != "inst", value};
}

const std::vector<mdr::WantedColumn>& branch_columns() {
  static const std::vector<mdr::WantedColumn> wanted{
      {{{"ratio to the instantaneous modulus",
         {"g", "gi", "alpha*", "\u03b1", "ratio*", "gratio*", "e", "ei", "prony*"},
         mdr::ratio_units()},
        {"modulus of the branch", {"gi", "ei", "g", "e", "modul*", "branchmod*", "mod*"}, mdr::modulus_units()}},
       false,
       true},
      {{{"relaxation time",
         {"tau*", "\u03c4", "\u03c4i", "t", "ti", "time*", "relaxationtime*", "branchtime*", "zeit*"},
         mdr::time_units()}}},
      {{{"ratio of the bulk modulus", {"k", "ki"}, mdr::ratio_units()}}, true},
      {{{"instantaneous modulus", {"e0", "g0", "einst", "ginst"}, mdr::modulus_units()}}, true}};
  return wanted;
}

/// E0 stands in the first row, or in all of them: taken out of the table before its rows are read.
std::string without_line(const std::vector<TextLine>& lines, std::size_t left_out) {
  std::string text;
  for (std::size_t i = 0; i < lines.size(); ++i) text += (i == left_out ? "" : lines[i].text) + "\n";
  return text;
}

bool begins_with_e(const std::string& name) {
  return !name.empty() && (name.front() == 'E' || name.front() == 'e');
}

void read_rows(const std::string& file, const mdr::ChosenColumns& chosen, double poisson_ratio,
               std::optional<bool> youngs, PronySeries& series) {
  const auto& csv = chosen.csv;
  const auto& wanted = branch_columns();
  series.times = csv.columns[1];
  const double second = csv.names.empty() ? 1 : mdr::unit_of_column(csv, 1, wanted[1].kinds[0].units, file);
  for (std::size_t i = 0; i < series.times.size(); ++i) {
    series.times[i] *= second;
    if (!(series.times[i] > 0))
      throw InputError(fmt::format("{}, line {}: a relaxation time of {:g} s; must be positive", file,
                                   csv.line_of_row[i], series.times[i]));
  }
  if (chosen.kind[2])
    for (std::size_t i = 0; i < csv.columns[2].size(); ++i)
      if (csv.columns[2][i] != 0)
        throw InputError(
            fmt::format("{}, line {}: k_{} = {:g}: the bulk modulus relaxes, which is not computed; must "
                        "be 0",
                        file, csv.line_of_row[i], i + 1, csv.columns[2][i]));
  auto values = csv.columns[0];
  const bool has_modulus_unit = mdr::names_unit(csv, 0) && chosen.kind[0] == std::optional<std::size_t>(1);
  if (has_modulus_unit) {
    const bool of_e = youngs.value_or(begins_with_e(csv.names[0]));
    const double size = mdr::unit_of_column(csv, 0, mdr::modulus_units(), file) / size_of(of_e, poisson_ratio);
    for (double& value : values) value *= size;
    series.moduli = std::move(values);
    for (std::size_t i = 0; i < series.moduli.size(); ++i)
      if (!(series.moduli[i] > 0))
        throw InputError(fmt::format("{}, line {}: a modulus of {:g} Pa; must be positive", file, csv.line_of_row[i],
                                     series.moduli[i]));
  } else {
    const bool percent = !csv.units.empty() && csv.units[0] == "%";
    if (!percent && std::any_of(values.begin(), values.end(), [](double v) { return v >= 1; }))
      throw InputError(fmt::format(
          "{}: column {} has no unit and is no ratio to the instantaneous modulus, with values of 1 and more; moduli "
          "need a unit, for example \"tau,E\" and \"s,MPa\"",
          file, csv.names.empty() ? std::string("1") : csv.names[0]));
    for (double& value : values) value *= percent ? 0.01 : 1;
    series.ratios = std::move(values);
  }
  if (chosen.kind[3]) {
    const bool of_e = youngs.value_or(begins_with_e(csv.names[3]));
    series.instantaneous =
        csv.columns[3][0] * mdr::unit_of_column(csv, 3, mdr::modulus_units(), file) / size_of(of_e, poisson_ratio);
    if (!mdr::names_unit(csv, 3))
      throw InputError(fmt::format("{}: column {} has no unit; must be Pa, kPa, MPa or GPa", file, csv.names[3]));
  }
}

}  // namespace

PronySeries read_prony_series(const std::string& file, double poisson_ratio, std::optional<bool> youngs) {
  return input_from(file, [&] {
    std::ifstream stream(file);
    const auto lines = mdr::read_lines(stream, file);
    if (is_abaqus(lines)) {
      auto series = read_abaqus(file, lines);
      require_known_ratio(file, series.ratios);
      return series;
    }
    PronySeries series;
    std::size_t left_out = lines.size();
    std::optional<NamedModulus> named;
    for (std::size_t i = 0; i < lines.size() && !named; ++i)
      if ((named = named_modulus(file, lines[i]))) left_out = i;
    std::istringstream rest(without_line(lines, left_out));
    const auto chosen = mdr::read_columns(rest, file, branch_columns(), mdr::InOrder::yes);
    read_rows(file, chosen, poisson_ratio, youngs, series);
    series.notes = skipped_text(file, chosen);
    if (named) {
      if (series.instantaneous)
        throw InputError(
            fmt::format("{}: has the instantaneous modulus in a line and in a column; must have one", file));
      (named->relaxed ? series.relaxed : series.instantaneous) =
          named->value / size_of(youngs.value_or(named->youngs), poisson_ratio);
    }
    if (!series.ratios.empty()) require_known_ratio(file, series.ratios);
    return series;
  });
}

void take_prony_series(const std::string& file, const PronySeries& series, Case::Elastomer& elastomer) {
  const double entry = elastomer.relaxed_modulus;
  const int n_known = (entry > 0) + series.instantaneous.has_value() + series.relaxed.has_value();
  if (n_known == 0)
    throw InputError(
        fmt::format("{}: says neither the instantaneous nor the relaxed modulus; must have a line like E0 = 12 MPa, or "
                    "the case a Relaxed shear modulus or an Instantaneous shear modulus",
                    file));
  if (n_known > 1)
    throw InputError(
        fmt::format("{}: the modulus that the series belongs to is given more than once, in the file and "
                    "in the case, or twice; must be given once",
                    file));
  const auto& shares = series.ratios.empty() ? series.moduli : series.ratios;
  const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
  double relaxed = series.relaxed.value_or(entry);
  elastomer.branch_moduli = series.moduli;
  if (series.ratios.empty()) {
    if (series.instantaneous) relaxed = *series.instantaneous - sum;
    if (!(relaxed > 0))
      throw InputError(
          fmt::format("{}: the moduli of the branches add up to {:g} Pa, the instantaneous shear modulus is "
                      "{:g} Pa; nothing is left for the relaxed one, which must be positive",
                      file, sum, series.instantaneous.value_or(0)));
  } else {
    const double instantaneous = series.instantaneous ? *series.instantaneous : relaxed / (1 - sum);
    relaxed = instantaneous * (1 - sum);
    for (const double ratio : series.ratios) elastomer.branch_moduli.push_back(ratio * instantaneous);
  }
  elastomer.relaxed_modulus = relaxed;
  elastomer.branch_times = series.times;
  elastomer.branches_file = file;
}

}  // namespace fretval
