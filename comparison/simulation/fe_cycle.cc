#include "comparison/simulation/fe_cycle.h"

#include "fem/motion/running_minimum.h"
#include "fem/ring_contact/stick_zone/cycle_response.h"

namespace fretval {

std::optional<CycleReadings> cycle_of(const FemCase& fem, double normal_force_max, const fem::NormalHistory& normal,
                                      const fem::FrictionHistory& friction) {
  if (fem.worn_edge || !fem.has_period() || fem.motion.tangential_amplitude() == 0) return std::nullopt;
  const auto cycle =
      fem::cycle_response(fem.relaxation, fem.friction_coefficient, fem.motion, normal_force_max, normal, friction);
  const double force = fem.units.force(), work = force * fem.units.depth;
  const auto& uncertain = cycle.uncertainty;
  const double friction_error = uncertain.friction_work * work, loss_error = uncertain.cycle_work * work;
  const auto& off = cycle.off_by_steps;
  const auto& between = cycle.between_steps;
  return CycleReadings{
      {{Quantity::tangential_force_max, {cycle.tangential_force_max * force, uncertain.tangential_force_max * force}},
       {Quantity::tangential_force_mean,
        {cycle.tangential_force_mean * force, uncertain.tangential_force_mean * force}},
       {Quantity::friction_work, {cycle.friction_work * work, friction_error}},
       {Quantity::bulk_work, {cycle.bulk_work * work, loss_error + friction_error}},
       {Quantity::cycle_work, {{}, loss_error}},
       {Quantity::tangential_work, {cycle.tangential_work * work, uncertain.tangential_work * work}}},
      cycle.sliding_force * force,
      cycle.sliding_work * work,
      {{Quantity::tangential_force_max, off.tangential_force_max * force},
       {Quantity::tangential_force_mean, off.tangential_force_mean * force},
       {Quantity::friction_work, off.work * work},
       {Quantity::bulk_work, off.work * work},
       {Quantity::cycle_work, off.work * work},
       {Quantity::tangential_work, off.work * work}},
      {{Quantity::tangential_force_max, between.tangential_force_max * force},
       {Quantity::tangential_force_mean, between.tangential_force_mean * force},
       {Quantity::friction_work, between.tangential_work * work},
       {Quantity::bulk_work, between.cycle_work * work},
       {Quantity::cycle_work, between.cycle_work * work},
       {Quantity::tangential_work, between.tangential_work * work}}};
}

CycleReadings cycle_of(const FemCase& fem, const fem::SurfaceHistory& history, double normal_work) {
  const double force = fem.units.force(), work = force * fem.units.depth;
  const Eigen::VectorXd along = history.forces.row(0);
  const double friction = history.dissipated.back() * work,
               loop = fem.motion.is_single_pass() ? 0 : history.tangential_work * work;
  const bool loses_inside = fem.relaxation.has_memory() && !fem.motion.is_single_pass();
  return {{{Quantity::tangential_force_max, {fem::largest_magnitude_of_period(along, history.pieces) * force, 0}},
           {Quantity::tangential_force_mean, {along.mean() * force, 0}},
           {Quantity::friction_work, {friction, 0}},
           {Quantity::bulk_work, {loses_inside ? loop + normal_work * work - friction : 0, 0}},
           {Quantity::cycle_work, {{}, 0}},
           {Quantity::tangential_work, {loop, 0}}},
          0,
          0};
}

void add_change(const CycleReadings& from, const CycleReadings& to, CycleReadings& cycle) {
  for (auto& [quantity, reading] : cycle.readings)
    if (reading.value) *reading.value += to.value(quantity) - from.value(quantity);
}

void go_halfway(const CycleReadings& other, CycleReadings& cycle) {
  for (auto& [quantity, reading] : cycle.readings)
    if (reading.value) reading.value = (*reading.value + other.value(quantity)) / 2;
  cycle.sliding_force = (cycle.sliding_force + other.sliding_force) / 2;
  cycle.sliding_work = (cycle.sliding_work + other.sliding_work) / 2;
}

}  // namespace fretval
