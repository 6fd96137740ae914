#pragma once

#include <optional>

#include "fem/history/relaxation.h"

namespace fretval::fem {

/// Motion of the indenter in dimensionless time t (omega = 1, a cycle is 2 pi): `d = d0 + e(t) Dd cos t`,
/// `u_x = e(t) u_x0 cos(t + phi(t))`. The envelope e rises smoothly from 0 to 1 over n_ramp_cycles, so that the history
/// starts relaxed at d0 and raises both amplitudes together.
///
/// A locked motion has a constant phase, and its period is one cycle. An unlocked one creeps from 0 to pi and back,
/// `phi = (pi/2)(1 - cos(t / n_creep_cycles))`: it rests for an instant at both ends, where the extremes of the load
/// lie, and its period is n_creep_cycles.
struct Motion {
  double indentation;
  double normal_amplitude;
  double tangential_amplitude;
  std::optional<double> phase;  ///< empty: unlocked
  int n_ramp_cycles = 10;
  int n_creep_cycles = 48;

  [[nodiscard]] int cycles_per_period() const { return phase ? 1 : n_creep_cycles; }
};

ValueAndRate normal_motion(const Motion& motion, double t);
ValueAndRate tangential_motion(const Motion& motion, double t);

}  // namespace fretval::fem
