#pragma once

#include "fem/history/normal_history.h"

namespace fretval::fem {

/// Largest force of the periodic state, dimensionless, and the uncertainty of its reading: of the peak between the
/// samples, and of a normal force that of the edges at the samples (see ContactForce).
struct LargestForce {
  double value, uncertainty;
};

/// Whether the profile has a worn flank, which touches all at once. With a flank around the contact the largest force
/// is that of the contact inside it; what the flank bears, which should be nothing, is a quantity of its own.
enum class Flank { none, around_contact };

/// oscillations: number of oscillations in a cycle of the fastest normal harmonic.
LargestForce largest_force(const NormalHistory& history, int oscillations = 1, Flank flank = Flank::none);

}  // namespace fretval::fem
