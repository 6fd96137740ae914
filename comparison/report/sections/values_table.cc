#include "comparison/report/sections/values_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "comparison/quantities/reading.h"
#include "comparison/results/answer_text.h"
#include "comparison/results/case_inputs.h"
#include "comparison/results/verdict_text.h"
#include "comparison/run/sweep_line.h"

namespace fretval {
namespace {

using nlohmann::ordered_json;
using Families = std::map<std::string, std::vector<const StoredResult*>>;

constexpr std::size_t few_families = 8;
constexpr double the_same = 1e-6;  // relative: six digits are shown

Families families_of_all(const std::vector<StoredResult>& results) {
  Families families;
  for (const auto& r : results) families[r.family()].push_back(&r);
  return families;
}

/// The reading of a quantity by one method; empty: the quantity is neither compared nor told by finite elements alone.
std::optional<Reading> reading_of(const StoredResult& r, const char* side, Quantity quantity) {
  const char* key = name_of(quantity);
  const auto bars = r.json.at("fe").value("error_estimate", ordered_json::object());
  const bool is_fe = side == std::string("fe");
  if (!r.json.at("comparison").contains(key) && !(is_fe && r.is_beyond_mdr() && bars.contains(key)))
    return std::nullopt;
  auto found = (is_fe ? fe_reading(r.json, quantity) : stored_reading(r.json.at("mdr"), quantity)).value_or(Reading{});
  for (auto* number : {&found.value, &found.uncertainty})
    if (*number) *number = without_roundoff(quantity, scales_of(r.json), **number);
  return found;
}

/// "690.2 ± 0.1 to 790.1 ± 0.1 µm"; both ends with their own unit where that is another one.
std::string range_text(const std::string& least, const std::string& most) {
  if (least == most) return least;
  const auto unit = [](const std::string& text) { return text.substr(std::min(text.rfind(' '), text.size())); };
  const auto start = unit(least) == unit(most) ? least.substr(0, least.rfind(' ')) : least;
  return start + " to " + most;
}

/// A value of all members of a family: one, or from the least to the largest.
std::string values_text(const std::vector<const StoredResult*>& family, const char* side, Quantity quantity) {
  std::vector<Reading> values;
  for (const auto* r : family)
    if (const auto value = reading_of(*r, side, quantity)) values.push_back(*value);
  if (values.empty()) return "–";
  const auto shown = [&](const Reading& one) {
    return one.value ? with_unit(*one.value, one.uncertainty.value_or(0), traits_of(quantity).unit)
                     : std::string("none");
  };
  const auto below = [](const Reading& a, const Reading& b) { return a.value < b.value; };
  const auto [least, most] = std::minmax_element(values.begin(), values.end(), below);
  const bool same =
      least->value && most->value &&
      *most->value - *least->value <= std::max(the_same * std::abs(*most->value), most->uncertainty.value_or(0));
  return same ? shown(*most) : range_text(shown(*least), shown(*most));
}

bool has(const std::vector<const StoredResult*>& family, Quantity quantity) {
  return std::any_of(family.begin(), family.end(),
                     [&](const auto* r) { return reading_of(*r, "fe", quantity).has_value(); });
}

/// The table of a family with nothing to compare.
std::string slides(const std::vector<const StoredResult*>& family, const char* side) {
  return fretval::slides(family.front()->json.at(side)) ? "all of the contact slides" : "–";
}

Table of_few(const Families& families, const std::vector<Quantity>& quantities) {
  Table table{{"", "finite elements", "MDR"}};
  for (const auto& [name, family] : families) {
    table.rows.push_back({head_cell(family.size() == 1 ? name : fmt::format("{}, {} cases", name, family.size()))});
    const auto before = table.rows.size();
    for (const auto quantity : quantities)
      if (has(family, quantity))
        table.rows.push_back({fmt::format("  {}", traits_of(quantity).title), values_text(family, "fe", quantity),
                              values_text(family, "mdr", quantity)});
    if (table.rows.size() == before)
      table.rows.back() = {table.rows.back().front(), slides(family, "fe"), slides(family, "mdr")};
  }
  return table;
}

Table of_many(const Families& families) {
  constexpr auto radius = Quantity::stick_radius_shakedown;
  Table table{{"stick radius, shakedown", "finite elements", "MDR"}};
  for (const auto& [name, family] : families)
    table.rows.push_back(has(family, radius) ? std::vector<Cell>{name, values_text(family, "fe", radius),
                                                                 values_text(family, "mdr", radius)}
                                             : std::vector<Cell>{name, slides(family, "fe"), slides(family, "mdr")});
  return table;
}

}  // namespace

Table values_table(const std::vector<StoredResult>& results, const std::vector<Quantity>& quantities) {
  const auto families = families_of_all(results);
  auto table = families.size() <= few_families ? of_few(families, quantities) : of_many(families);
  table.label = "the values of both methods";
  return table;
}

Table sweep_rows(const std::vector<StoredResult>& family) {
  const auto& first = family.front();
  const auto entry = first.entry(), second = first.second_entry();
  std::vector<Quantity> shown;
  for (const auto& pair : {std::pair{Quantity::stick_radius_first_slip, Quantity::stick_radius_shakedown},
                           std::pair{Quantity::contact_radius_max, Quantity::normal_force_max}}) {
    for (const auto quantity : {pair.first, pair.second})
      if (std::any_of(family.begin(), family.end(), [&](const auto& r) {
            const auto fe = reading_of(r, "fe", quantity), mdr = reading_of(r, "mdr", quantity);
            return (fe && fe->value) || (mdr && mdr->value);
          }))
        shown.push_back(quantity);
    if (!shown.empty()) break;
  }
  Table table{{entry}};
  if (!second.empty()) table.heads.push_back(second);
  for (const auto quantity : shown) {
    table.heads.emplace_back(traits_of(quantity).title);
    table.heads.emplace_back("MDR");
  }
  table.heads.emplace_back("");
  for (const auto& r : family) {
    std::vector<Cell> row{input_text(r.sweep_value(), unit_of_entry(entry), 6)};
    if (!second.empty()) row.push_back(input_text(r.second_value(), unit_of_entry(second), 6));
    for (const auto quantity : shown)
      for (const char* side : {"fe", "mdr"}) row.push_back(values_text({&r}, side, quantity));
    const auto outcome = stored_outcome(r.json);
    row.push_back(words_cell(outcome == Outcome::agree ? "" : name_of(outcome)));
    table.rows.push_back(std::move(row));
  }
  return table;
}

const std::vector<Quantity>& main_quantities() {
  static const std::vector<Quantity> quantities{Quantity::stick_radius_first_slip, Quantity::stick_radius_shakedown,
                                                Quantity::contact_radius_max, Quantity::normal_force_max,
                                                Quantity::friction_work};
  return quantities;
}

const std::vector<Quantity>& quantities_with_units() {
  static const std::vector<Quantity> quantities = [] {
    std::vector<Quantity> all;
    for (const auto quantity : quantities_by_interest)
      if (*traits_of(quantity).unit != '\0' && quantity != Quantity::worn_volume) all.push_back(quantity);
    return all;
  }();
  return quantities;
}

}  // namespace fretval
