#pragma once

#include <stdexcept>

namespace fretval::fem {

/// The whole contact slides under a prescribed tangential force: |F_x| has come to mu F_N, and no displacement of the
/// indenter balances it. What the case does, and no failure of its computation.
struct GrossSlip : std::runtime_error {
  GrossSlip(double when, double share)
      : std::runtime_error("gross slip: the tangential force reaches mu times the normal force"),
        time(when),
        amplitude(share) {}

  double time;       ///< dimensionless, from the start of the history on
  double amplitude;  ///< of all oscillations then, over that of the case: less than 1 in the ramp
};

}  // namespace fretval::fem
