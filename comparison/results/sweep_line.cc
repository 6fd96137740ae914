#include "comparison/results/sweep_line.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "comparison/case/case_file.h"
#include "comparison/case/entry_table.h"
#include "comparison/reference/mdr_answer.h"
#include "comparison/results/results_folder.h"
#include "comparison/support/files.h"

namespace fretval {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t n_values = 100;

constexpr std::array closed_forms{Quantity::stick_radius_first_slip, Quantity::stick_radius_shakedown,
                                  Quantity::contact_radius_max, Quantity::worn_radius};

bool is_quick(const Case& input) {
  const auto& motion = input.motion;
  return !motion.normal_force && !motion.tangential_force && motion.normal_harmonics.empty() &&
         !input.elastomer.master_curve;
}

/// The answer without the forces, which springs are stepped for. The contact radius is that of g(a) = d, a worn profile
/// has none.
MdrAnswer closed_answer(const MdrCase& mdr) {
  mdr::NormalResponse radius_alone{};
  radius_alone.contact_radius_max =
      mdr.limiting ? std::nan("") : mdr::inverse_transform(mdr.profile, deepest_indentation(mdr));
  return mdr_answer(mdr, radius_alone);
}

/// A value in a line; "nan" for what MDR refuses between the points of the sweep.
std::string row_of(const Case& input) {
  nlohmann::ordered_json answer;
  try {
    answer = to_json(closed_answer(mdr_case(input)));
  } catch (const std::runtime_error&) {
  } catch (const std::invalid_argument&) {
  }
  std::string row = fmt::format("{:.10g}", input.sweep->value);
  for (const auto quantity : closed_forms) {
    const auto value = answer.find(name_of(quantity));
    row += value != answer.end() && value->is_number() && std::isfinite(value->get<double>())
               ? fmt::format(",{:.10g}", value->get<double>())
               : ",nan";
  }
  return row + "\n";
}

std::string header_of(const std::string& entry) {
  std::string header = column_of_entry(entry);
  for (const auto quantity : closed_forms) header += "," + column_of(quantity);
  return header + "\n";
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

void write_sweep_lines(const std::vector<Case>& cases, const fs::path& output) {
  std::set<std::string> families;
  for (const auto& input : cases) {
    if (!input.sweep || !families.insert(input.sweep->family).second) continue;
    const auto file = output / input.sweep->family / "mdr.csv";
    fs::remove(file);
    const auto between = is_quick(input) ? cases_between(input.file, n_values) : std::vector<Case>{};
    if (between.empty()) continue;
    std::string text = header_of(input.sweep->entry);
    for (const auto& one : between) text += row_of(one);
    fs::create_directories(file.parent_path());
    write_file(file, text);
  }
}

std::pair<std::vector<double>, std::vector<double>> read_sweep_line(const fs::path& family, const std::string& entry,
                                                                    Quantity quantity) {
  return read_columns(family / "mdr.csv", column_of_entry(entry), column_of(quantity));
}

}  // namespace fretval
