#include "comparison/quantities/reading.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "comparison/support/json.h"

namespace fretval {

using nlohmann::ordered_json;

double CycleReadings::value(Quantity quantity) const {
  const auto found = readings.find(quantity);
  return found == readings.end() ? 0 : found->second.value.value_or(0);
}

double CycleReadings::uncertainty(Quantity quantity) const {
  const auto found = readings.find(quantity);
  return found == readings.end() ? 0 : found->second.uncertainty.value_or(0);
}

void add_cycle(const CycleReadings& cycle, Readings& readings) {
  const double bulk = cycle.value(Quantity::bulk_work);
  for (const auto& [quantity, reading] : cycle.readings) {
    readings[quantity] = reading;
    if (traits_of(quantity).of_periodic_state) readings[quantity].is_compared = bulk > 0;
  }
  readings.at(Quantity::cycle_work).value = cycle.value(Quantity::friction_work) + bulk;
}

std::optional<double> difference_of(Quantity quantity, const Reading& fe, const Reading& mdr, const Scales& scales) {
  if (!fe.value || !mdr.value) return std::nullopt;
  return (*fe.value - *mdr.value) / scale_of(quantity, scales, *mdr.value);
}

double only_one_of(Quantity quantity, const Reading& fe, const Reading& mdr, const Scales& scales) {
  if (fe.value && mdr.value) return 0;
  const double one = fe.value.value_or(0) - mdr.value.value_or(0);
  return one == 0 ? 0 : one / scale_of(quantity, scales, one);
}

Quantities uncertainties_of(const Readings& readings, const Scales& scales) {
  Quantities uncertainties;
  for (const auto& [quantity, reading] : readings)
    if (reading.is_compared && reading.uncertainty)
      uncertainties[quantity] = *reading.uncertainty / scale_of(quantity, scales, reading.value.value_or(0));
  return uncertainties;
}

Quantities errors_of(const Quantities& values, const Quantities& reference) {
  Quantities errors;
  for (const auto& [quantity, value] : values) {
    const auto found = reference.find(quantity);
    if (found != reference.end() && traits_of(quantity).refined_for == RefinedFor::any_case)
      errors[quantity] = std::abs(value - found->second);
  }
  return errors;
}

double largest_of(const Quantities& errors) {
  if (errors.empty()) return std::nan("");
  return std::max_element(errors.begin(), errors.end(),
                          [](const auto& a, const auto& b) { return a.second < b.second; })
      ->second;
}

void add_readings(const Readings& readings, ordered_json& json) {
  auto uncertainty = ordered_json::object(), absent = ordered_json::object();
  for (const auto quantity : quantities_by_interest) {
    const auto found = readings.find(quantity);
    if (found == readings.end()) continue;
    const auto& reading = found->second;
    json[name_of(quantity)] = or_null(reading.value);
    if (!reading.value) absent[name_of(quantity)] = reading.why_absent;
    if (reading.value && reading.uncertainty) uncertainty[name_of(quantity)] = *reading.uncertainty;
  }
  if (!uncertainty.empty()) json["uncertainty"] = std::move(uncertainty);
  if (!absent.empty()) json["absent"] = std::move(absent);
}

std::optional<Reading> stored_reading(const ordered_json& method, Quantity quantity) {
  const char* key = name_of(quantity);
  if (!method.contains(key)) return std::nullopt;
  Reading reading{number_in(method, key)};
  if (const auto found = method.find("uncertainty"); found != method.end())
    reading.uncertainty = number_in(*found, key);
  if (const auto found = method.find("absent"); found != method.end()) reading.why_absent = found->value(key, "");
  return reading;
}

}  // namespace fretval
