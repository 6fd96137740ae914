#include "comparison/reference/cycle_of_springs.h"

#include <nlohmann/json.hpp>

namespace fretval {
namespace {

/// The cycle of any stepped response. way: the length of the tangential path of the indenter.
template <class Response>
CycleReadings readings_of(const MdrCase& mdr, const Response& response, const Response& error, double normal_force_max,
                          double way) {
  const auto force = if_any(std::max(error.tangential_force_max, error.tangential_force_mean)),
             work = if_any(error.friction_work + error.bulk_work);
  const double sliding_force = mdr.friction_coefficient * normal_force_max;
  return {{{Quantity::tangential_force_max, {response.tangential_force_max, force}},
           {Quantity::tangential_force_mean, {response.tangential_force_mean, force}},
           {Quantity::friction_work, {response.friction_work, work}},
           {Quantity::bulk_work, {response.bulk_work, work}},
           {Quantity::cycle_work, {{}, work}},
           {Quantity::tangential_work, {response.tangential_work, if_any(error.tangential_work)}}},
          sliding_force,
          sliding_force * way};
}

}  // namespace

bool settles_for_long(const mdr::PronyBody& body, double period) {
  constexpr int many_periods = 100, all_periods = 2000;  // ten creep times
  const int n = mdr::periods_of_creep(body, period);
  return n > (body.viscosity > 0 ? many_periods : all_periods / 2 - 1);
}

std::optional<mdr::CommonCycle> cycle_to_step(const MdrCase& mdr) {
  const auto& harmonics = mdr.motion.tangential;
  const bool moves = std::any_of(harmonics.begin(), harmonics.end(), [](const auto& h) { return h.amplitude > 0; });
  if (mdr.limiting || !mdr.motion.phase_locked || !moves) return std::nullopt;
  const auto cycle = mdr::common_cycle(mdr.motion);
  if (!cycle || cycle->highest_order() > longest_cycle) return std::nullopt;
  return settles_for_long(mdr.body, 1 / cycle->frequency) ? std::nullopt : cycle;
}

std::optional<CycleReadings> cycle_of_springs(const MdrCase& mdr, const mdr::SteppedForcedResponse& stepped,
                                              double normal_force_max) {
  const auto cycle = cycle_to_step(mdr);
  if (!cycle) return std::nullopt;
  double sum = 0, path = 0;
  for (std::size_t k = 0; k < mdr.motion.tangential.size(); ++k) {
    sum += mdr.motion.tangential[k].amplitude;
    path += 4 * mdr.motion.tangential[k].amplitude * cycle->tangential_orders[k];
  }
  const auto& [response, error] = stepped;
  if (mdr.tangential_force) path *= response.tangential_amplitude / sum;
  auto readings = readings_of(mdr, response, error, normal_force_max, path);
  leave_out_unknown_force(mdr, readings);
  return readings;
}

CycleReadings cycle_along(const MdrCase& mdr, mdr::PathForces forces, mdr::PathForces error, double normal_force_max) {
  if (mdr.is_single_pass()) forces.bulk_work = error.bulk_work = forces.tangential_work = 0;
  return readings_of(mdr, forces, error, normal_force_max, forces.tangential_way);
}

void leave_out_unknown_force(const MdrCase& mdr, CycleReadings& cycle) {
  if (mdr.body.viscosity > 0 && !mdr.is_single_pass() && !mdr.cycle_tolerance)
    cycle.readings.erase(Quantity::tangential_force_max);
}

void divide_works(double displacement, CycleReadings& cycle) {
  constexpr auto friction = Quantity::friction_work, bulk = Quantity::bulk_work, loop = Quantity::tangential_work;
  const double normal_loss = cycle.value(friction) + cycle.value(bulk) - cycle.value(loop);
  for (auto& [quantity, reading] : cycle.readings) {
    if (traits_of(quantity).unit != std::string("J")) continue;
    if (reading.value) *reading.value /= displacement;
    if (reading.uncertainty) *reading.uncertainty /= displacement;
  }
  cycle.sliding_work /= displacement;
  cycle.readings.at(bulk).value = normal_loss + cycle.value(loop) - cycle.value(friction);
}

}  // namespace fretval
