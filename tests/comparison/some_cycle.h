#pragma once

#include "comparison/quantities/reading.h"

namespace fretval {

/// The cycle of an answer that is made up: largest and mean force, and works. Its scales are of 1 N and 1e-4 J.
struct MadeUpCycle {
  double force_max, force_mean, friction, bulk, loop;
  double force_error = 0, friction_error = 0, loss_error = 0, loop_error = 0;
};

inline CycleReadings some_cycle(const MadeUpCycle& made_up) {
  const auto& [force_max, force_mean, friction, bulk, loop, force_error, friction_error, loss_error, loop_error] =
      made_up;
  return {{{Quantity::tangential_force_max, {force_max, force_error}},
           {Quantity::tangential_force_mean, {force_mean, force_error}},
           {Quantity::friction_work, {friction, friction_error}},
           {Quantity::bulk_work, {bulk, loss_error + friction_error}},
           {Quantity::cycle_work, {{}, loss_error}},
           {Quantity::tangential_work, {loop, loop_error}}},
          1,
          1e-4};
}

}  // namespace fretval
