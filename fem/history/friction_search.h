#pragma once

#include <Eigen/Dense>

#include "fem/history/friction_contact.h"
#include "fem/history/normal_history.h"
#include "fem/history/periodic_state.h"

namespace fretval::fem {

/// The periodic state of a friction under the repeating cycle of a normal contact, found from where it is, at the start
/// of a period of a locked motion (find_periodic_state). Which rings have never slipped is left to plain periods: a
/// search may let rings slip that would not on the way from rest, so those whose slip_path is zero are put back, with
/// the memory of others that have not slipped. Rings that have to slip will do so in the plain periods that follow, and
/// have not come to their periodic state yet: to_come is infinite then.
PeriodicState find_periodic_friction(const FrictionContact& contact, const NormalHistory& normal,
                                     const Eigen::VectorXd& slip_path, double tolerance);

}  // namespace fretval::fem
