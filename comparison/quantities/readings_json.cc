#include "comparison/quantities/readings_json.h"

#include <nlohmann/json.hpp>

#include "comparison/support/json.h"

namespace fretval {

using nlohmann::ordered_json;

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
  const auto number = [key](const ordered_json& from) {
    const auto found = from.find(key);
    return found != from.end() && found->is_number() ? std::optional(found->get<double>()) : std::nullopt;
  };
  if (!method.contains(key)) return std::nullopt;
  Reading reading{number(method)};
  if (const auto found = method.find("uncertainty"); found != method.end()) reading.uncertainty = number(*found);
  if (const auto found = method.find("absent"); found != method.end()) reading.why_absent = found->value(key, "");
  return reading;
}

}  // namespace fretval
