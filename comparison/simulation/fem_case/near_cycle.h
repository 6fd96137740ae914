#pragma once

#include <functional>

#include "mdr/motion/harmonic_motion.h"

namespace fretval {

/// A cycle for a motion whose frequencies have no common period, or a long one, in the course of which every lag
/// between its two directions comes by. The normal frequencies are kept, the tangential ones rounded to whole orders.
struct NearCycle {
  mdr::CommonCycle cycle;
  bool creeps;             ///< the tangential motion has to creep through the lags, see fem::Motion
  double error_of_demand;  ///< of the depth that an element asks for to stick, m
};

/// The body's |G|/G(0) at a frequency in Hz.
using Stiffening = std::function<double(double frequency)>;

/// The one with the smallest error of those of at most 2 n_creep_cycles oscillations of the fastest harmonic, the
/// shortest if even that has more. In m, with tangential amplitudes over 3 mu/2 and both times |G|/G(0):
///
///   lags      (A B/(A + B)) (pi/l)^2/2,   A = sum_j a_j n_j^2,  B = sum_k b_k m_k^2,  l = least common multiple of
///             how often either direction repeats in a cycle: lags are the same that differ by 2 pi/l, and where the
///             extremes of both directions miss each other by half of that, each takes its share. Creeping in N
///             cycles: pi/l (pi/N) in place of pi/l
///   rounding  sum_k b_k | |G(w_k)| - |G(rounded w_k)| |/G(0)
///
/// A cycle creeps if there is time for 12 of it, in N = fem::creep_period cycles.
NearCycle near_cycle(const mdr::HarmonicMotion& motion, const Stiffening& stiffening, double friction_coefficient,
                     int n_creep_cycles);

}  // namespace fretval
