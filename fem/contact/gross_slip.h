#pragma once

#include <stdexcept>

namespace fretval::fem {

/// The whole contact slides under a prescribed tangential force: |F_x| has come to mu F_N, and no displacement of the
/// indenter balances it. This is what the case does, not a failure of the computation.
struct GrossSlip : std::runtime_error {
  GrossSlip(double when, double share)
      : std::runtime_error("gross slip: the tangential force reaches mu times the normal force"),
        time(when),
        amplitude(share) {}

  double time;       ///< dimensionless, from the start of the history on
  double amplitude;  ///< amplitudes of all oscillations at that time over those of the case: less than 1 in the ramp
};

}  // namespace fretval::fem
