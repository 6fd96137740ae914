#pragma once

#include "fem/history/normal_history.h"

namespace fretval::fem {

/// Largest normal force of the periodic state, dimensionless, and how uncertain its reading is: of the edges at its
/// instants (see ContactForce), and of the peak between the samples.
struct LargestForce {
  double value, uncertainty;
};

/// Of a worn profile, which touches all at once: the largest force is that of the contact inside it. What the flank
/// bears, which should be nothing, is a quantity of its own.
enum class Flank { none, around_contact };

/// oscillations: of the normal motion in a cycle, of its fastest harmonic.
LargestForce largest_force(const NormalHistory& history, int oscillations = 1, Flank flank = Flank::none);

}  // namespace fretval::fem
