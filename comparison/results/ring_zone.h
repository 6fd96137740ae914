#pragma once

#include <cmath>

#include "fem/condensation/revolved_surface.h"

namespace fretval {

/// What a ring does: it slips if its traction is at the friction limit, to roundoff.
inline fem::RingZone zone_of(double pressure, double traction, double friction_coefficient) {
  constexpr double roundoff = 1e-9;
  if (pressure <= 0) return fem::RingZone::open;
  if (std::abs(traction) < friction_coefficient * pressure * (1 - roundoff)) return fem::RingZone::sticks;
  return traction > 0 ? fem::RingZone::slips_forward : fem::RingZone::slips_backward;
}

}  // namespace fretval
