#include "comparison/results/sweep_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>

#include "comparison/case/case_file.h"
#include "comparison/case/entry_table.h"
#include "comparison/reference/mdr_answer.h"
#include "comparison/reference/normal_responses.h"
#include "comparison/results/results_folder.h"
#include "comparison/support/files.h"
#include "comparison/support/log.h"
#include "comparison/support/parallel.h"

namespace fretval {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t n_values = 100, n_values_where_costly = 24;
constexpr const char *closed_file = "mdr.csv", *stepped_file = "mdr_springs.csv";

using QuantityList = std::vector<Quantity>;
const QuantityList closed_forms{Quantity::stick_radius_first_slip, Quantity::stick_radius_shakedown,
                                Quantity::contact_radius_max, Quantity::worn_radius};

bool has_closed_forms(const Case& input) {
  const auto& motion = input.motion;
  return !motion.normal_force && !motion.tangential_force && motion.normal_harmonics.empty() &&
         !input.elastomer.master_curve;
}

/// The answer without the forces, which springs are stepped for. The contact radius is that of g(a) = d, a worn profile
/// has none.
nlohmann::ordered_json closed_answer(const Case& input) {
  const auto mdr = mdr_case(input);
  mdr::NormalResponse radius_alone{};
  radius_alone.contact_radius_max =
      mdr.limiting ? std::nan("") : mdr::inverse_transform(mdr.profile, deepest_indentation(mdr));
  return to_json(mdr_answer(mdr, radius_alone));
}

using LineAnswer = std::function<nlohmann::ordered_json(const Case&)>;

struct Sweep {
  const Case* first;
  std::size_t n_cases;
  /// What MDR has said at points of the sweep, by their values.
  std::map<double, nlohmann::ordered_json> known = {};
};

/// What becomes a file.
struct Line {
  fs::path file;
  std::vector<Case> cases;
  LineAnswer answer;
  QuantityList quantities;
  std::vector<nlohmann::ordered_json> answers = std::vector<nlohmann::ordered_json>(cases.size());
};

/// Null for what MDR refuses between the points of a sweep.
void answer_all(std::vector<Line>& lines) {
  std::vector<std::pair<Line*, std::size_t>> points;
  for (auto& line : lines)
    for (std::size_t i = 0; i < line.cases.size(); ++i) points.emplace_back(&line, i);
  for_each_in_parallel(points.size(), [&](std::size_t n) {
    const auto& [line, i] = points[n];
    try {
      line->answers[i] = line->answer(line->cases[i]);
    } catch (const std::runtime_error&) {
    } catch (const std::invalid_argument&) {
    }
  });
}

bool has_number(const nlohmann::ordered_json& answer, Quantity quantity) {
  const auto value = answer.find(name_of(quantity));
  return value != answer.end() && value->is_number() && std::isfinite(value->get<double>());
}

/// Columns that no answer has a number for are left out.
std::string table_of(const Line& line) {
  const auto& cases = line.cases;
  const auto& answers = line.answers;
  auto quantities = line.quantities;
  const auto has_none = [&](Quantity quantity) {
    return std::none_of(answers.begin(), answers.end(), [&](const auto& one) { return has_number(one, quantity); });
  };
  quantities.erase(std::remove_if(quantities.begin(), quantities.end(), has_none), quantities.end());
  std::string text = column_of_entry(cases.front().sweep->entry);
  for (const auto quantity : quantities) text += "," + column_of(quantity);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    text += fmt::format("\n{:.10g}", cases[i].sweep->value);
    for (const auto quantity : quantities)
      text += has_number(answers[i], quantity) ? fmt::format(",{:.10g}", answers[i].at(name_of(quantity)).get<double>())
                                               : ",nan";
  }
  return text + "\n";
}

/// In the order in which they come. computed: of each case, or empty.
std::vector<Sweep> sweeps_among(const std::vector<Case>& cases, const std::vector<BatchLine>& computed) {
  std::vector<Sweep> sweeps;
  std::map<std::string, std::size_t> place;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const auto& input = cases[i];
    if (!input.sweep) continue;
    const auto [found, is_new] = place.emplace(input.sweep->family, sweeps.size());
    if (is_new) sweeps.push_back({&input, 0});
    auto& sweep = sweeps[found->second];
    ++sweep.n_cases;
    if (i < computed.size() && !computed[i].json.empty())
      sweep.known[input.sweep->value] = nlohmann::ordered_json::parse(computed[i].json).at("mdr");
  }
  return sweeps;
}

}  // namespace

std::string unit_of_entry(const std::string& entry) {
  const auto slash = entry.find(" / ");
  if (slash == std::string::npos) return "";
  const auto* traits = find_entry(entry.substr(0, slash), entry.substr(slash + 3));
  return traits && !traits->dimensions.empty() ? base_unit(traits->dimensions.front()) : "";
}

std::string column_of_entry(const std::string& entry) {
  const auto unit = unit_of_entry(entry);
  return fmt::format("{} [{}]", entry, unit.empty() ? "1" : unit);
}

void write_sweep_lines(const std::vector<Case>& cases, const fs::path& output, const std::vector<BatchLine>& computed) {
  const auto sweeps = sweeps_among(cases, computed);
  NormalResponses normal_responses;
  const auto n_of_one_sweep = std::max(n_values_where_costly, n_values / std::max<std::size_t>(1, sweeps.size()));
  QuantityList all(quantities_by_interest.begin(), quantities_by_interest.end());
  // Springs are stepped for that in a history of its own, at the points alone.
  all.erase(std::find(all.begin(), all.end(), Quantity::cycles_to_shakedown));
  std::vector<Line> lines;
  for (const auto& sweep : sweeps) {
    const auto stepped_answer = [&normal_responses, &sweep](const Case& input) {
      if (const auto known = sweep.known.find(input.sweep->value); known != sweep.known.end()) return known->second;
      const auto mdr = mdr_case(input);
      return to_json(mdr_answer_with_cycle(mdr, *normal_responses.of(input, mdr)));
    };
    const auto* input = sweep.first;
    const auto folder = output / input->sweep->family;
    for (const char* name : {closed_file, stepped_file}) fs::remove(folder / name);
    // Of a sweep whose results already have as many values, nothing.
    const auto add_line = [&](const char* name, std::size_t n, const LineAnswer& answer,
                              const QuantityList& quantities) {
      if (auto between = cases_between(input->file, n); between.size() > sweep.n_cases)
        lines.push_back({folder / name, std::move(between), answer, quantities});
    };
    const bool costly = !has_closed_forms(*input);
    if (!costly) {
      add_line(closed_file, n_values, closed_answer, closed_forms);
    } else if (mdr_case(*input).has_period()) {
      log::info(fmt::format("{}: MDR is stepped in time between the points", input->sweep->family));
    } else {
      log::info(
          fmt::format("{}: springs of a motion without period take seconds for a value: no line between the points",
                      input->sweep->family));
      continue;
    }
    add_line(stepped_file, costly ? n_values_where_costly : n_of_one_sweep, stepped_answer, all);
  }
  answer_all(lines);
  for (const auto& line : lines) {
    fs::create_directories(line.file.parent_path());
    write_file(line.file, table_of(line));
  }
}

std::pair<std::vector<double>, std::vector<double>> read_sweep_line(const fs::path& family, const std::string& entry,
                                                                    Quantity quantity) {
  for (const char* name : {closed_file, stepped_file})
    if (auto line = read_columns(family / name, column_of_entry(entry), column_of(quantity)); !line.second.empty())
      return line;
  return {};
}

}  // namespace fretval
