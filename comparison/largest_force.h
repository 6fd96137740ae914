#pragma once

#include "comparison/scene.h"
#include "fem/contact_problem.h"
#include "fem/normal_history.h"

namespace fretval {

/// Largest normal force of the periodic state, dimensionless, and how uncertain its reading is: of the edges at its
/// instants (see fem::ContactForce), of the peak between the samples, and of what rings and steps do not show of it
/// however they are compared.
struct LargestForce {
  double value, uncertainty;
};
LargestForce largest_force(const fem::ContactProblem& problem, const FemScene& scene,
                           const fem::NormalHistory& history);

}  // namespace fretval
