#pragma once

#include <optional>

#include "fem/contact/contact_problem.h"
#include "fem/history/normal_history.h"

namespace fretval::fem {

/// What its reading has to know of a body and its indenter besides the history.
struct ForceContext {
  const RelaxationModel& relaxation;
  std::optional<double> sharp_edge = {};  ///< radius at which the slope of the indenter jumps
  bool worn = false;                      ///< profile with a flank that touches all at once
  int oscillations = 1;                   ///< of the normal motion in a cycle, of its fastest harmonic
};

/// Largest normal force of the periodic state, dimensionless, and how uncertain its reading is: of the edges at its
/// instants (see ContactForce), of the peak between the samples, and of what rings and steps do not show of it
/// however they are compared. Of a worn profile, that of the contact inside its flank: what the flank bears, which
/// should be nothing, is a quantity of its own.
struct LargestForce {
  double value, uncertainty;
};
LargestForce largest_force(const ContactProblem& problem, const ForceContext& context, const NormalHistory& history);

}  // namespace fretval::fem
