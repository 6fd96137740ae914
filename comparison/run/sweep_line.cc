#include "comparison/run/sweep_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "comparison/case_file/case_file.h"
#include "comparison/case_file/entry_lookup.h"
#include "comparison/reference/incompressible_case.h"
#include "comparison/reference/mdr_readings.h"
#include "comparison/reference/normal_responses.h"
#include "comparison/reference/plane_answer.h"
#include "comparison/results/results_folder.h"
#include "comparison/support/files.h"
#include "comparison/support/json.h"
#include "comparison/support/log.h"

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
  const bool by_force = motion.normal_force || motion.tangential_force || (motion.path && motion.path->has_forces());
  return !by_force && !motion.moves_across() && !is_layer_of_mdr(input) && motion.normal_harmonics.empty() &&
         !input.elastomer.master_curve;
}

/// MDR's answer without the forces, for which springs would be stepped. The contact radius is that of g(a) = d; a worn
/// profile has none.
nlohmann::ordered_json closed_answer(const Case& input) {
  const auto mdr = mdr_case(input);
  mdr::NormalResponse radius_alone{};
  radius_alone.contact_radius_max = mdr.limiting ? std::nan("") : unworn_radius_at(mdr, deepest_indentation(mdr));
  return to_json(mdr_answer(mdr, radius_alone));
}

/// Over a layer and under displacements springs are few already: with half of them the mean force on a layer is 4 % of
/// its largest value off.
bool has_many_springs(const MdrCase& mdr) {
  return !mdr.layer && (mdr.has_forces() || moves_in_plane(mdr) || (mdr.path && mdr.path->has_forces()));
}

nlohmann::ordered_json stepped_answer(const Case& input, NormalResponses& normal_responses) {
  auto mdr = mdr_case(input);
  mdr.tolerance = 0;  // nothing is compared between the points
  if (has_many_springs(mdr)) mdr.coarser_springs = 2;
  return to_json(mdr_answer_with_cycle(mdr, *normal_responses.of(input, mdr)));
}

bool has_number(const nlohmann::ordered_json& answer, Quantity quantity) {
  return std::isfinite(number_or_nan(answer, name_of(quantity)));
}

/// The cases of one sweep, by their values: their places among all.
struct Sweep {
  const Case* first;
  std::map<double, std::size_t> places = {};
};

/// The sweeps among some cases, in the order in which they come.
std::vector<Sweep> sweeps_among(const std::vector<Case>& cases) {
  std::vector<Sweep> sweeps;
  std::map<std::string, std::size_t> place;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const auto& input = cases[i];
    if (!input.sweep || !input.sweep->second_entry.empty()) continue;
    const auto [found, is_new] = place.emplace(input.sweep->family, sweeps.size());
    if (is_new) sweeps.push_back({&input});
    sweeps[found->second].places[input.sweep->value] = i;
  }
  return sweeps;
}

}  // namespace

std::string unit_of_entry(const std::string& entry) {
  const auto* traits = find_entry(entry);
  return traits && !traits->dimensions.empty() ? base_unit(traits->dimensions.front()) : "";
}

std::string symbol_of_entry(const std::string& entry) {
  const auto* traits = find_entry(entry);
  return traits ? traits->symbol : "";
}

std::string column_of_entry(const std::string& entry) {
  const auto unit = unit_of_entry(entry);
  return fmt::format("{} [{}]", entry, unit.empty() ? "1" : unit);
}

/// A file of a sweep, and the cases of its line.
struct SweepLines::Line {
  fs::path file;  // in the output
  std::vector<Case> cases;
  bool stepped;
  QuantityList quantities;
  std::map<double, std::size_t> places = {};  // of cases at its values
  std::vector<nlohmann::ordered_json> answers = std::vector<nlohmann::ordered_json>(cases.size());

  /// MDR's answer to case i; null where MDR refuses a case between the points of a sweep.
  [[nodiscard]] nlohmann::ordered_json answer(std::size_t i, NormalResponses& normal_responses) const try {
    return stepped ? stepped_answer(cases[i], normal_responses) : closed_answer(cases[i]);
  } catch (const std::runtime_error&) {
    return nullptr;
  } catch (const std::invalid_argument&) {
    return nullptr;
  }

  /// Columns that no answer has a number for are left out.
  [[nodiscard]] std::string table() const {
    auto shown = quantities;
    const auto has_none = [&](Quantity quantity) {
      return std::none_of(answers.begin(), answers.end(), [&](const auto& one) { return has_number(one, quantity); });
    };
    shown.erase(std::remove_if(shown.begin(), shown.end(), has_none), shown.end());
    std::string text = column_of_entry(cases.front().sweep->entry);
    for (const auto quantity : shown) text += "," + column_of(quantity);
    for (std::size_t i = 0; i < cases.size(); ++i) {
      text += fmt::format("\n{:.10g}", cases[i].sweep->value);
      for (const auto quantity : shown)
        text += has_number(answers[i], quantity)
                    ? fmt::format(",{:.10g}", answers[i].at(name_of(quantity)).get<double>())
                    : ",nan";
    }
    return text + "\n";
  }
};

/// Some values of a line: springs are stepped for one at a time.
struct SweepLines::Task {
  std::size_t line, first, n;
};

SweepLines::SweepLines(const std::vector<Case>& cases) {
  const auto sweeps = sweeps_among(cases);
  const auto n_of_one_sweep = std::max(n_values_where_costly, n_values / std::max<std::size_t>(1, sweeps.size()));
  QuantityList all(quantities_by_interest.begin(), quantities_by_interest.end());
  // The cycles to shakedown take a history of their own, which is stepped at the points alone.
  all.erase(std::find(all.begin(), all.end(), Quantity::cycles_to_shakedown));
  for (const auto& input : cases)
    if (input.sweep) folders_.insert(input.sweep->family);
  for (const auto& [first, places] : sweeps) {
    const fs::path folder = first->sweep->family;
    // No line is needed for a sweep whose results have as many values themselves.
    const auto add_line = [&](Line line) {
      if (line.cases.size() > line.places.size()) lines_.push_back(std::move(line));
    };
    const bool costly = !has_closed_forms(*first);
    if (!costly) {
      add_line({folder / closed_file, cases_between(first->file, n_values), false, closed_forms, places});
    } else if (mdr_case(*first).has_period()) {
      costly_.push_back(folder);
    } else {
      without_line_.push_back(folder);
      continue;
    }
    add_line({folder / stepped_file, cases_between(first->file, costly ? n_values_where_costly : n_of_one_sweep), true,
              all, places});
  }
  for (std::size_t number = 0; number < lines_.size(); ++number) {
    const auto& line = lines_[number];
    if (!line.stepped) tasks_.push_back({number, 0, line.cases.size()});
    for (std::size_t i = 0; line.stepped && i < line.cases.size(); ++i)
      if (line.places.count(line.cases[i].sweep->value) == 0) tasks_.push_back({number, i, 1});
  }
}

SweepLines::~SweepLines() = default;

BesideCases SweepLines::work() {
  const auto compute = [this](std::size_t number) {
    const auto& [line, first, n] = tasks_[number];
    nlohmann::ordered_json answers;
    for (std::size_t i = first; i < first + n; ++i) answers.push_back(lines_[line].answer(i, normal_responses_));
    return answers.dump();
  };
  const auto take = [this](std::size_t number, const std::string& text) {
    const auto& [line, first, n] = tasks_[number];
    auto answers = nlohmann::ordered_json::parse(text);
    for (std::size_t i = 0; i < n; ++i) lines_[line].answers[first + i] = std::move(answers.at(i));
  };
  return {tasks_.size(), compute, take};
}

void SweepLines::log_costs() const {
  for (const auto& family : costly_) log::info(fmt::format("{}: MDR is stepped in time between the points", family));
  for (const auto& family : without_line_)
    log::info(fmt::format("{}: springs of a motion without period take seconds for a value: no line between the points",
                          family));
}

void SweepLines::write(const fs::path& output, const std::vector<BatchLine>& computed) {
  for (const auto& folder : folders_)
    for (const char* name : {closed_file, stepped_file}) fs::remove(output / folder / name);
  for (auto& line : lines_) {
    for (std::size_t i = 0; line.stepped && i < line.cases.size(); ++i) {
      const auto place = line.places.find(line.cases[i].sweep->value);
      if (place == line.places.end()) continue;
      const auto& known = computed.at(place->second).json;
      line.answers[i] =
          known.empty() ? line.answer(i, normal_responses_) : nlohmann::ordered_json::parse(known).at("mdr");
    }
    fs::create_directories((output / line.file).parent_path());
    write_file(output / line.file, line.table());
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
