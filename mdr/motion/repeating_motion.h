#pragma once

#include "mdr/motion/harmonic_motion.h"

namespace fretval::mdr {

/// A motion that repeats itself, to be stepped in the place of one that may not. In the course of its period every
/// relation of the phases that occurs in the other motion comes by, or one close to it.
struct RepeatingMotion {
  HarmonicMotion motion;  ///< commensurate
  double cycle;           ///< common period of its harmonics, s
  int n_cycles = 1;       ///< in a period
  double lag = 0;         ///< s; the tangential motion creeps ahead by it in the course of a period, and back
  int n_slow = 1;         ///< oscillations of its slowest harmonic in a period

  [[nodiscard]] double period() const { return n_cycles * cycle; }
  /// How many periods have n_oscillations of the slowest harmonic, rounded up.
  [[nodiscard]] int periods_with(int n_oscillations) const { return (n_oscillations + n_slow - 1) / n_slow; }
  /// Steps in a period, with steps_per_oscillation of them in an oscillation of the fastest harmonic.
  [[nodiscard]] int steps_with(int steps_per_oscillation) const;
  /// Lag by which the tangential motion is ahead at a time in s, and its rate: `(lag/2) (1 - cos(2 pi t/period))`.
  [[nodiscard]] double lag_at(double time) const;
  [[nodiscard]] double lag_rate_at(double time) const;
};

/// A motion that has a common period and a locked phase is its own. An unlocked phase creeps through all lags in as
/// many cycles as have n_oscillations of the fastest harmonic. Frequencies without a common period are rounded to those
/// of a cycle of at most n_oscillations of the fastest one: commensurate frequencies stay commensurate, with the phases
/// between them, and the first group keeps its frequencies. Among the possible cycles the one is taken with the least
///
///   sum over groups of |f/f_rounded - 1| + (1/sum over groups of 1/m^2) lag^2/2,
///
/// m: how often a group repeats in the cycle. Phases between two groups that differ by 2 pi/l, with l the least common
/// multiple of their m, are the same relation, so the lag is at most pi/l; or, where each direction is a group and
/// there is time for 12 cycles, pi/N of that, as the motion creeps through it in N cycles. time 0 of the motion has to
/// be one of largest indentation, see from_largest_indentation(). Throws std::invalid_argument for a bad motion.
RepeatingMotion repeating_motion(const HarmonicMotion& motion, int n_oscillations);

}  // namespace fretval::mdr
