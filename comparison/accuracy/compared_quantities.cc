#include "comparison/accuracy/compared_quantities.h"

#include <algorithm>
#include <cmath>

#include "comparison/reference/mdr_answer.h"
#include "comparison/simulation/compute_case.h"

namespace fretval {

namespace {

/// Of either answer: a normal force and what it makes the indenter do, of which one is prescribed.
template <class Answer>
void add_response(const Answer& answer, double normal_force_max, const Units& units, Quantities& values) {
  if (answer.indentation_max)
    values[Quantity::indentation_max] = std::log(*answer.indentation_max / units.depth);
  else
    values[Quantity::normal_force_max] = std::log(normal_force_max / units.force());
  if (answer.tangential_amplitude)
    values[Quantity::tangential_amplitude] = std::log(*answer.tangential_amplitude / units.depth);
}

/// Of either answer. Without memory friction takes all that is lost.
template <class Cycle>
void add_cycle(const std::optional<Cycle>& cycle, const Units& units, Quantities& values) {
  if (!cycle) return;
  values[Quantity::tangential_force_max] = std::log(cycle->tangential_force_max / units.force());
  values[Quantity::tangential_force_mean] = cycle->tangential_force_mean / cycle->sliding_force;
  values[Quantity::friction_work] = cycle->friction_work / cycle->sliding_work;
  if (!(cycle->bulk_work > 0)) return;
  const auto add = [&](Quantity quantity, double work) {
    values[quantity] = std::log(work / (units.force() * units.depth));
  };
  add(Quantity::cycle_work, cycle->friction_work + cycle->bulk_work);
  add(Quantity::bulk_work, cycle->bulk_work);
  add(Quantity::tangential_work, cycle->tangential_work);
}

}  // namespace

Quantities quantities_of(const FeAnswer& fe, const Units& units) {
  Quantities values;
  add_response(fe, fe.normal_force_max, units, values);
  add_cycle(fe.cycle, units, values);
  if (fe.slip_decay) values[Quantity::slip_decay] = std::log(fe.slip_decay->factor);
  if (fe.cycles_to_shakedown) values[Quantity::cycles_to_shakedown] = std::log(*fe.cycles_to_shakedown);
  if (fe.zones) {  // whose unit of length is no contact radius, and whose stick radii are ends of zones
    values[Quantity::contact_radius_max] = std::log(fe.contact_radius_max.value() / units.length);
    return values;
  }
  if (fe.axis_pressure_max) values[Quantity::axis_pressure_max] = std::log(*fe.axis_pressure_max / units.pressure());
  if (fe.contact_radius_max) values[Quantity::contact_radius_max] = *fe.contact_radius_max / units.length;
  values[Quantity::stick_radius_first_slip] = fe.stick_radius_first_slip.value_or(0) / units.length;
  if (!fe.single_pass) values[Quantity::stick_radius_shakedown] = fe.stick_radius_shakedown.value_or(0) / units.length;
  if (fe.no_wear) {
    values[Quantity::slip_inside_stick_zone] = fe.no_wear->slip_inside;
    values[Quantity::force_outside_stick_zone] = fe.no_wear->force_outside;
    values[Quantity::maximum_indentation] = fe.no_wear->touch_indentation;
    if (fe.no_wear->limiting_amplitude) values[Quantity::limiting_amplitude] = *fe.no_wear->limiting_amplitude;
  }
  return values;
}

Quantities quantities_of(const MdrAnswer& mdr, const Units& units, bool worn) {
  Quantities values;
  if (mdr.axis_pressure) values[Quantity::axis_pressure_max] = std::log(mdr.axis_pressure->largest / units.pressure());
  values[Quantity::contact_radius_max] = mdr.contact_radius_max.value() / units.length;
  add_response(mdr, mdr.normal_force_max.value(), units, values);
  add_cycle(mdr.cycle, units, values);
  if (mdr.slip_decay) values[Quantity::slip_decay] = std::log(*mdr.slip_decay);
  if (mdr.cycles_to_shakedown) values[Quantity::cycles_to_shakedown] = std::log(mdr.cycles_to_shakedown->cycles);
  values[Quantity::stick_radius_first_slip] = mdr.stick_radius_first_slip.value_or(0) / units.length;
  if (!mdr.single_pass)
    values[Quantity::stick_radius_shakedown] = mdr.stick_radius_shakedown.value_or(0) / units.length;
  if (worn) {
    if (mdr.wears_no_more()) values[Quantity::slip_inside_stick_zone] = 0;
    values[Quantity::force_outside_stick_zone] = 0;
    values[Quantity::maximum_indentation] = 1;
    if (mdr.limiting_amplitude) values[Quantity::limiting_amplitude] = *mdr.limiting_amplitude;
  }
  return values;
}

Quantities stepping_errors_of(const MdrAnswer& mdr) {
  Quantities errors;
  const auto add = [&](Quantity quantity, double error, double scale) {
    if (error > 0) errors[quantity] = error / scale;
  };
  if (mdr.normal_force_max) add(Quantity::normal_force_max, mdr.normal_force_error, *mdr.normal_force_max);
  if (mdr.axis_pressure) add(Quantity::axis_pressure_max, mdr.axis_pressure->error, mdr.axis_pressure->largest);
  if (mdr.cycles_to_shakedown)
    add(Quantity::cycles_to_shakedown, mdr.cycles_to_shakedown->error, mdr.cycles_to_shakedown->cycles);
  if (!mdr.cycle) return errors;
  const auto& cycle = *mdr.cycle;
  add(Quantity::tangential_force_max, cycle.force_error, cycle.tangential_force_max);
  add(Quantity::tangential_force_mean, cycle.force_error, cycle.sliding_force);
  add(Quantity::friction_work, cycle.work_error, cycle.sliding_work);
  add(Quantity::cycle_work, cycle.work_error, cycle.friction_work + cycle.bulk_work);
  add(Quantity::bulk_work, cycle.work_error, cycle.bulk_work);
  add(Quantity::tangential_work, cycle.loop_error, cycle.tangential_work);
  return errors;
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
