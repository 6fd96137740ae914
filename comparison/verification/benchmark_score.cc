#include "comparison/verification/benchmark_score.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparison/case/case.h"
#include "comparison/results/unit_text.h"
#include "comparison/support/json.h"
#include "comparison/support/text.h"
#include "mdr/support/csv.h"
#include "mdr/support/csv_units.h"

namespace fretval {
namespace {

using nlohmann::ordered_json;
using UnitSizes = std::map<std::string, double>;

const ordered_json& benchmarks() {
  static const auto all = ordered_json::parse(benchmarks_json).at("cases");
  return all;
}

const UnitSizes& units_for(Quantity quantity) {
  static const UnitSizes energies{{"J", 1},          {"mJ", 1e-3},      {"uJ", 1e-6},
                                  {"\u00b5J", 1e-6}, {"\u03bcJ", 1e-6}, {"nJ", 1e-9}};
  const std::string unit = traits_of(quantity).unit;
  if (unit == "m") return mdr::length_units();
  if (unit == "N") return mdr::force_units();
  if (unit == "Pa") return mdr::modulus_units();
  return unit == "J" ? energies : mdr::ratio_units();
}

/// Whether a line is neither blank nor a comment.
bool has_fields(const mdr::TextLine& line) {
  const auto begin = line.text.find_first_not_of(" \t");
  return begin != std::string::npos && line.text[begin] != '#';
}

/// The quantities of all benchmarks.
std::vector<std::string> names_of_quantities() {
  std::vector<std::string> names;
  for (const auto& one : benchmarks())
    for (const auto& [name, unused] : one.at("answer").items())
      if (std::count(names.begin(), names.end(), name) == 0) names.push_back(name);
  return names;
}

const ordered_json& answer_of_benchmark(const std::string& benchmark) {
  for (const auto& one : benchmarks())
    if (one.at("name") == benchmark) return one.at("answer");
  const auto names = benchmark_names();
  throw InputError(fmt::format("--benchmark {}: no such benchmark{}; expected one of {}", benchmark,
                               did_you_mean(benchmark, names), fmt::join(names, ", ")));
}

std::optional<double> number_or_none(const ordered_json& value) {
  return value.is_number() ? std::optional(value.get<double>()) : std::nullopt;
}

bool is_radius(Quantity quantity) {
  return traits_of(quantity).scale.over == Over::contact_radius;
}

/// What a value is that is not the one it stands for: the other stick radius.
std::string other_radius(const ordered_json& answer, Quantity quantity, double value, double most) {
  const bool first = quantity == Quantity::stick_radius_first_slip;
  if (!first && quantity != Quantity::stick_radius_shakedown) return "";
  const auto other = first ? Quantity::stick_radius_shakedown : Quantity::stick_radius_first_slip;
  const auto found = answer.find(name_of(other));
  if (found == answer.end() || !found->at("mdr").is_number()) return "";
  return std::abs(value - found->at("mdr").get<double>()) <= most ? fmt::format("is the {}", traits_of(other).title)
                                                                  : "";
}

}  // namespace

std::vector<std::string> benchmark_names() {
  std::vector<std::string> names;
  for (const auto& one : benchmarks()) names.push_back(one.at("name"));
  return names;
}

std::map<Quantity, double> read_foreign_answer(std::istream& stream, const std::string& source_name) {
  const auto known = names_of_quantities();
  const auto valid = fmt::format(
      "a line of names of quantities, one of their units and one of numbers, for example \"contact_radius_max,"
      "stick_radius_shakedown\", \"mm,mm\", \"1.0954,0.7928\"; quantities are {}",
      fmt::join(known, ", "));
  try {
    const auto lines = mdr::read_lines(stream, source_name);
    const auto first = std::find_if(lines.begin(), lines.end(), has_fields);
    if (first == lines.end()) throw InputError(fmt::format("{}: is empty; expected {}", source_name, valid));
    const auto csv = mdr::read_csv(lines, source_name, mdr::split_fields(first->text).values.size());
    if (csv.names.empty()) throw InputError(fmt::format("{}: has no names; expected {}", source_name, valid));
    if (csv.line_of_row.size() != 1)
      throw InputError(
          fmt::format("{}: has {} rows of numbers; expected {}", source_name, csv.line_of_row.size(), valid));
    std::map<Quantity, double> values;
    for (std::size_t column = 0; column < csv.names.size(); ++column) {
      const auto name = csv.names[column].substr(0, csv.names[column].find_first_of(" [("));
      const auto quantity = quantity_of(name);
      if (!quantity || std::count(known.begin(), known.end(), name) == 0)
        throw InputError(fmt::format("{}: column {}: no such quantity of a benchmark{}; expected {}", source_name,
                                     csv.names[column], did_you_mean(name, known), valid));
      if (!mdr::names_unit(csv, column) && *traits_of(*quantity).unit != '\0')
        throw InputError(fmt::format("{}: column {} has no unit; expected {}", source_name, name, valid));
      if (!values
               .emplace(*quantity,
                        csv.columns[column][0] * mdr::unit_of_column(csv, column, units_for(*quantity), source_name))
               .second)
        throw InputError(fmt::format("{}: column {} is there twice; expected each quantity once", source_name, name));
    }
    return values;
  } catch (const std::invalid_argument& error) {
    throw InputError(error.what());
  }
}

std::vector<ScoreRow> benchmark_score(const std::string& benchmark, const std::map<Quantity, double>& foreign,
                                      double tolerance) {
  const auto& answer = answer_of_benchmark(benchmark);
  const double radius = answer.at(name_of(Quantity::contact_radius_max)).at("mdr").get<double>();
  std::vector<ScoreRow> rows;
  for (const auto& [name, both] : answer.items()) {
    const auto quantity = quantity_of(name).value();
    ScoreRow row{quantity, std::nullopt, number_or_none(both.at("mdr")), number_or_none(both.at("fe")),
                 number_or_none(both.at("error_bar")).value_or(0)};
    const auto given = foreign.find(quantity);
    if (given != foreign.end()) row.value = given->second;
    const auto reference = row.fe ? row.fe : row.mdr;
    if (row.value && reference) {
      const double scale = is_radius(quantity) ? radius : std::abs(*reference);
      row.difference = (*row.value - *reference) / (scale > 0 ? scale : 1);
      row.agrees = std::abs(*row.difference) <= tolerance;
      if (!row.agrees) row.remark = other_radius(answer, quantity, *row.value, tolerance * radius);
    } else if (row.value) {
      row.agrees = false;
      row.remark = "there is none";
    }
    rows.push_back(row);
  }
  for (const auto& [quantity, value] : foreign) {
    if (answer.contains(name_of(quantity))) continue;
    const bool sticks = is_of_stick_zone(quantity);
    rows.push_back({quantity, value, {}, {}, 0, {}, !sticks, sticks ? "there is none" : "not in this benchmark"});
  }
  if (std::none_of(rows.begin(), rows.end(), [](const ScoreRow& row) { return row.value.has_value(); }))
    throw InputError(fmt::format("--benchmark {}: the table has none of its quantities", benchmark));
  return rows;
}

std::string score_text(const std::string& benchmark, const std::vector<ScoreRow>& rows, double tolerance) {
  std::size_t n_given = 0, n_agree = 0;
  std::string lines;
  for (const auto& row : rows) {
    const auto& traits = traits_of(row.quantity);
    const auto shown = [&](const std::optional<double>& value, double bar) {
      return value ? with_unit(*value, bar, traits.unit) : std::string("none");
    };
    const bool is_held = row.value && (row.difference || !row.agrees);
    n_given += is_held ? 1 : 0;
    n_agree += is_held && row.agrees ? 1 : 0;
    const auto* verdict = row.agrees ? "" : "DISAGREES";
    const auto line = fmt::format("  {:<28} {:<16} {:<28} {:<16} {:<10} {}{}{}", traits.title,
                                  row.value ? with_unit(*row.value, 0, traits.unit) : "–", shown(row.fe, row.error_bar),
                                  shown(row.mdr, 0), row.difference ? fmt::format("{:+.1e}", *row.difference) : "–",
                                  verdict, row.agrees || row.remark.empty() ? "" : ": ", row.remark);
    lines += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return fmt::format(
      "{}: {} of {} quantities agree within {:g} with finite elements; {} not given\n"
      "  {:<28} {:<16} {:<28} {:<16} {}\n{}",
      benchmark, n_agree, n_given, tolerance, rows.size() - n_given, "", "yours", "finite elements", "MDR",
      "yours less finite elements", lines);
}

ordered_json score_json(const std::string& benchmark, const std::vector<ScoreRow>& rows, double tolerance) {
  ordered_json json{{"benchmark", benchmark}, {"tolerance", tolerance}};
  for (const auto& row : rows)
    json["quantities"][name_of(row.quantity)] = {{"value", or_null(row.value)},
                                                 {"fe", or_null(row.fe)},
                                                 {"error_bar", row.error_bar},
                                                 {"mdr", or_null(row.mdr)},
                                                 {"difference", or_null(row.difference)},
                                                 {"agrees", row.agrees},
                                                 {"remark", row.remark}};
  return json;
}

}  // namespace fretval
