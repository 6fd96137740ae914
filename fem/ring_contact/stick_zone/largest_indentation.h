#pragma once

#include "fem/history/normal_history.h"
#include "fem/ring_contact/contact_problem.h"

namespace fretval::fem {

/// Largest indentation of the periodic state under a prescribed normal force, dimensionless, and how far it may be off
/// because the readings of the force are uncertain (see ContactForce): an error dF of a reading moves the indenter by
/// dF/(k a S) in the step, k a the force of a unit punch, S the response of the body to a displacement within the step,
/// and what it has moved goes back as the body relaxes.
struct LargestIndentation {
  double value, uncertainty;
};
LargestIndentation largest_indentation(const ContactProblem& problem, const RelaxationModel& relaxation,
                                       const NormalHistory& history);

}  // namespace fretval::fem
