#pragma once

#include <functional>

#include "mdr/motion/harmonic_motion.h"

namespace fretval {

/// A cycle for a motion whose frequencies have no common period, or a long one, in the course of which every relation
/// of its phases comes by.
struct NearCycle {
  mdr::CommonCycle cycle;
  bool creeps;             ///< the tangential motion has to creep through the lags, see fem::Motion
  double error_of_demand;  ///< of the depth that an element asks for to stick, in the unit of the demands
  double error_of_normal;  ///< the part of it that the rounding of normal frequencies makes
};

/// The body's |G|/G(0) at a frequency in Hz.
using Stiffening = std::function<double(double frequency)>;

/// Depth that an oscillation of this amplitude, and of a frequency in Hz, asks of an element to stick: a displacement
/// times |G|/G(0) there.
using Demand = std::function<double(double amplitude, double frequency)>;

/// What an element asks for, of either direction.
struct Demands {
  Demand normal, tangential;
  /// Tangential displacements of another frequency are scaled by |G| there, so that they ask for the same.
  bool scaled;
};

/// Harmonics that are multiples of one frequency stay so; of two such groups, or of the two directions of a motion that
/// is one, the first keeps its frequencies and the other one is rounded to whole orders. Of the cycles of at most
/// 2 n_creep_cycles oscillations of the fastest harmonic the one with the smallest error, the shortest if even that has
/// more:
///
///   lags      (A B/(A + B)) (pi/l)^2/2,   A and B = sum of demand order^2 in either group,
///             l = least common multiple of how often they repeat in a cycle: lags are the same that differ by 2 pi/l,
///             and where the extremes of both miss each other by half of that, each takes its share.
///             Creeping in N cycles: pi/l (pi/N) in place of pi/l
///   rounding  sum of demand | |G(w)|/|G(rounded w)| - 1|, of a displacement in force, of a force in displacement;
///             none of what is scaled
///
/// Where it is scaled, a tangential motion that is a group of its own and more than 8 times faster or slower than the
/// other one is brought to the golden ratio: what an element asks for depends on the relations of the phases, all of
/// which come by in any case, and on amplitudes of forces.
///
/// A cycle creeps if there is time for 12 of it, in N = fem::creep_period cycles, and each group is a direction. Throws
/// std::invalid_argument for more than two groups (see mdr::harmonic_groups).
NearCycle near_cycle(const mdr::HarmonicMotion& motion, const Stiffening& stiffening, const Demands& demands,
                     int n_creep_cycles);

}  // namespace fretval
