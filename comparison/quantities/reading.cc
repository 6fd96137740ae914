#include "comparison/quantities/reading.h"

#include <algorithm>
#include <cmath>

namespace fretval {

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

}  // namespace fretval
