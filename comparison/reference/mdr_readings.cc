#include "comparison/reference/mdr_readings.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "comparison/quantities/reading.h"
#include "comparison/reference/cycle_of_springs.h"

namespace fretval {
namespace {

void take_kind(const UnwornAnswer& /*unused*/, Readings& /*unused*/) {}

void take_kind(const LimitingAnswer& limiting, Readings& readings) {
  readings[Quantity::limiting_amplitude] = {
      limiting.amplitude, {}, "nothing moves tangentially", limiting.amplitude.has_value()};
}

void take_kind(const GrossSlipShare& /*unused*/, Readings& readings) {
  for (const auto quantity : {Quantity::stick_radius_first_slip, Quantity::stick_radius_shakedown})
    readings.at(quantity).why_absent = "the whole contact slides";
  for (auto& [quantity, reading] : readings) reading.is_compared = false;
}

}  // namespace

Readings readings_of(const MdrAnswer& answer) {
  Readings readings{
      {Quantity::contact_radius_max,
       {answer.contact_radius_max, if_any(answer.contact_radius_error), "no contact carries the force without slip"}},
      {Quantity::stick_radius_first_slip,
       {answer.stick_radius_first_slip, if_any(answer.stepped.first_slip), "nothing sticks"}},
      {Quantity::stick_radius_shakedown,
       {answer.stick_radius_shakedown, if_any(answer.stepped.shakedown), "nothing sticks"}},
      {Quantity::worn_radius, {answer.worn_radius, {}, "wear goes on", false}},
      {Quantity::normal_force_max,
       {answer.normal_force_max, if_any(answer.normal_force_error), "not computed; see --springs",
        !answer.indentation_max}},
      {Quantity::limiting_amplitude, {{}, {}, "the indenter is not worn", false}}};
  if (answer.axis_pressure)
    readings[Quantity::axis_pressure_max] = {answer.axis_pressure->largest, if_any(answer.axis_pressure->error)};
  if (answer.indentation_max)
    readings[Quantity::indentation_max] = {answer.indentation_max, if_any(answer.stepped.indentation)};
  if (answer.tangential_amplitude)
    readings[Quantity::tangential_amplitude] = {answer.tangential_amplitude,
                                                if_any(answer.stepped.tangential_amplitude)};
  if (answer.cycle) add_cycle(*answer.cycle, readings);
  if (answer.transverse_force_max)
    readings[Quantity::transverse_force_max] = {answer.transverse_force_max, if_any(answer.transverse_force_error)};
  if (answer.slip_decay) readings[Quantity::slip_decay] = {answer.slip_decay};
  if (const auto& settling = answer.cycles_to_shakedown)
    readings[Quantity::cycles_to_shakedown] = {settling->cycles, if_any(settling->error)};
  std::visit([&](const auto& kind) { take_kind(kind, readings); }, answer.of_kind);
  keep_to(answer.motion_kind, readings);
  return readings;
}

Readings compared_readings_of(const MdrAnswer& answer) {
  auto readings = readings_of(answer);
  if (!answer.as<LimitingAnswer>()) return readings;
  if (answer.wears_no_more()) readings[Quantity::slip_inside_stick_zone] = {0};
  readings[Quantity::force_outside_stick_zone] = {0};
  readings[Quantity::maximum_indentation] = {1};
  return readings;
}

nlohmann::ordered_json to_json(const MdrAnswer& answer) {
  nlohmann::ordered_json json{{"modulus_ratio", std::isnan(answer.modulus_ratio)
                                                    ? nlohmann::ordered_json(nullptr)
                                                    : nlohmann::ordered_json(answer.modulus_ratio)}};
  add_readings(readings_of(answer), json);
  if (const auto& cycle = answer.cycle)
    json["cycle_error"] = {{"force", cycle->uncertainty(Quantity::tangential_force_mean)},
                           {"work", cycle->uncertainty(Quantity::friction_work)},
                           {"loop", cycle->uncertainty(Quantity::tangential_work)}};
  if (const auto& settling = answer.cycles_to_shakedown) json["cycles_to_shakedown_error"] = settling->error;
  if (answer.stepping_error > 0) json["stepping_error"] = answer.stepping_error;
  if (answer.steady_sliding_share) json["steady_sliding_share"] = *answer.steady_sliding_share;
  if (const auto* slip = answer.as<GrossSlipShare>()) {
    json["gross_slip"] = slip->amplitude;
    if (slip->time) json["gross_slip_time"] = *slip->time;
  }
  return json;
}

Scales scales_of(const MdrAnswer& answer, double contact_radius) {
  if (!answer.cycle) return {contact_radius, 0, 0};
  return {contact_radius, answer.cycle->sliding_force, answer.cycle->sliding_work};
}

}  // namespace fretval
