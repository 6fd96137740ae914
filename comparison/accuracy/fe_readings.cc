#include "comparison/accuracy/fe_readings.h"

#include <cmath>

namespace fretval {
namespace {

void take_kind(const DiscAnswer& /*unused*/, Readings& /*unused*/) {}

void take_kind(const NoWearEvidence& evidence, Readings& readings) {
  readings[Quantity::slip_inside_stick_zone] = {evidence.slip_inside};
  readings[Quantity::force_outside_stick_zone] = {evidence.force_outside};
  readings[Quantity::maximum_indentation] = {evidence.touch_indentation};
  readings[Quantity::limiting_amplitude] = {
      evidence.limiting_amplitude, {}, "nothing moves tangentially", evidence.limiting_amplitude.has_value()};
}

void take_kind(const SurfaceAnswer& surface, Readings& readings) {
  const auto add = [&](Quantity along, Quantity across, const PlaneZone& zone) {
    const std::string why = zone.radius > 0 ? "" : "nothing sticks";
    const auto some = [&](double extent) { return zone.radius > 0 ? std::optional(extent) : std::nullopt; };
    readings[along] = {some(zone.along), zone.edge_uncertainty, why};
    readings[across] = {some(zone.across), zone.edge_uncertainty, why};
  };
  add(Quantity::contact_along, Quantity::contact_across, surface.contact);
  add(Quantity::first_slip_along, Quantity::first_slip_across, surface.never_slipped);
  add(Quantity::shakedown_along, Quantity::shakedown_across, surface.sticks_in_a_cycle);
  if (surface.grid.mirrors == fem::Mirrors::none)
    readings[Quantity::transverse_force_max] = {surface.transverse_force_max};
}

/// Zones that may be annuli have bars of their own (ZoneBudget): their radii are not compared.
void take_kind(const ZoneAnswer& /*unused*/, Readings& readings) {
  for (const auto quantity :
       {Quantity::stick_radius_first_slip, Quantity::stick_radius_shakedown, Quantity::axis_pressure_max})
    if (const auto found = readings.find(quantity); found != readings.end()) found->second.is_compared = false;
}

void take_kind(const GrossSlipStart& /*unused*/, Readings& readings) {
  for (auto& [quantity, reading] : readings) reading = {{}, {}, "the whole contact slides", false};
}

/// Unit of a quantity in a dimensionless answer; a quantity in m is a radius or a depth.
double unit_of(Quantity quantity, const Units& units) {
  const std::string unit = traits_of(quantity).unit;
  if (unit == "N") return units.force();
  if (unit == "J") return units.force() * units.depth;
  if (unit == "Pa") return units.pressure();
  if (unit != "m") return 1;
  return quantity == Quantity::contact_radius_max ? units.length : units.depth;
}

double compared_value(Quantity quantity, double value, const Scales& scales, const Units& units) {
  if (is_relative(quantity, scales)) return std::log(value / unit_of(quantity, units));
  return value / scale_of(quantity, scales, value);
}

}  // namespace

Readings readings_of(const FeAnswer& fe, const Units& units) {
  Readings readings{
      {Quantity::contact_radius_max,
       {fe.contact_radius_max, fe.contact_radius_uncertainty, "the flank of a worn profile touches without pressure",
        fe.contact_radius_max.has_value()}},
      {Quantity::stick_radius_first_slip, {fe.stick_radius_first_slip, fe.first_slip_uncertainty, "nothing sticks"}},
      {Quantity::stick_radius_shakedown, {fe.stick_radius_shakedown, fe.shakedown_uncertainty, "nothing sticks"}},
      {Quantity::normal_force_max, {fe.normal_force_max, fe.normal_force_uncertainty, "", !fe.indentation_max}}};
  if (fe.axis_pressure_max) readings[Quantity::axis_pressure_max] = {fe.axis_pressure_max, fe.axis_pressure_uncertainty};
  if (fe.indentation_max) readings[Quantity::indentation_max] = {fe.indentation_max, fe.indentation_uncertainty};
  if (fe.tangential_amplitude) readings[Quantity::tangential_amplitude] = {fe.tangential_amplitude};
  if (fe.cycle)
    add_cycle(*fe.cycle, readings);
  else if (fe.normal.pressure.size() > 0)  // not compared: of a cycle that stands for none, or of a worn indenter
    readings[Quantity::friction_work] = {fe.friction.dissipated_energy * units.force() * units.depth, {}, "", false};
  if (fe.slip_decay) readings[Quantity::slip_decay] = {fe.slip_decay->factor, fe.slip_decay->uncertainty};
  if (fe.cycles_to_shakedown)
    readings[Quantity::cycles_to_shakedown] = {fe.cycles_to_shakedown, fe.cycles_to_shakedown_uncertainty};
  std::visit([&](const auto& kind) { take_kind(kind, readings); }, fe.of_kind);
  keep_to(fe.motion_kind, readings);
  return readings;
}

Scales scales_of(const FeAnswer& fe, const Units& units) {
  Scales scales{fe.as<ZoneAnswer>() ? 0 : units.length, 0, 0};
  if (fe.cycle) {
    scales.sliding_force = fe.cycle->sliding_force;
    scales.sliding_work = fe.cycle->sliding_work;
  }
  return scales;
}

Quantities compared_quantities(const Readings& readings, const Scales& scales, const Units& units) {
  Quantities quantities;
  for (const auto& [quantity, reading] : readings) {
    if (!reading.is_compared) continue;
    const double value = reading.value.value_or(0);
    if (is_relative(quantity, scales) && value <= 0) continue;  // no larger than its error, or absent
    quantities[quantity] = reading.value ? compared_value(quantity, value, scales, units) : 0;
  }
  return quantities;
}

Quantities quantities_of(const FeAnswer& fe, const Units& units) {
  return compared_quantities(readings_of(fe, units), scales_of(fe, units), units);
}

}  // namespace fretval
