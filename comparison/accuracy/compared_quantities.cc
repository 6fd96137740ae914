#include "comparison/accuracy/compared_quantities.h"

#include <algorithm>
#include <cmath>

#include "comparison/reference/mdr_answer.h"
#include "comparison/simulation/simulation.h"

namespace fretval {

Measures measures_of(const FeAnswer& fe, const Units& units) {
  Measures measures;
  if (fe.contact_radius_max) measures["contact_radius_max"] = *fe.contact_radius_max / units.length;
  measures["normal_force_max"] = std::log(fe.normal_force_max / units.force());
  measures["stick_radius_first_slip"] = fe.stick_radius_first_slip.value_or(0) / units.length;
  measures["stick_radius_shakedown"] = fe.stick_radius_shakedown.value_or(0) / units.length;
  if (fe.no_wear) {
    measures["slip_inside_stick_zone"] = fe.no_wear->slip_inside;
    measures["force_outside_stick_zone"] = fe.no_wear->force_outside;
    measures["maximum_indentation"] = fe.no_wear->touch_indentation;
  }
  return measures;
}

Measures measures_of(const MdrAnswer& mdr, const Units& units, bool worn) {
  Measures measures;
  measures["contact_radius_max"] = mdr.contact_radius_max.value() / units.length;
  measures["normal_force_max"] = std::log(mdr.normal_force_max.value() / units.force());
  measures["stick_radius_first_slip"] = mdr.stick_radius_first_slip.value_or(0) / units.length;
  measures["stick_radius_shakedown"] = mdr.stick_radius_shakedown.value_or(0) / units.length;
  if (worn) {
    measures["slip_inside_stick_zone"] = 0;
    measures["force_outside_stick_zone"] = 0;
    measures["maximum_indentation"] = 1;
  }
  return measures;
}

Measures errors_of(const Measures& measures, const Measures& reference) {
  Measures errors;
  for (const auto& [quantity, value] : measures) {
    const auto found = reference.find(quantity);
    if (found != reference.end()) errors[quantity] = std::abs(value - found->second);
  }
  return errors;
}

double largest_of(const Measures& errors) {
  if (errors.empty()) return std::nan("");
  return std::max_element(errors.begin(), errors.end(),
                          [](const auto& a, const auto& b) { return a.second < b.second; })
      ->second;
}

}  // namespace fretval
