#pragma once

#include "fem/history/friction_history.h"
#include "fem/history/normal_history.h"

namespace fretval::fem {

/// What is left open where all of a contact slides until an instant within a step. Dimensionless.
///
/// With R = mu F_N - |F_x|, the room that friction leaves, sliding ends where the rate at which sticking makes room
/// rises through 0. A step around that instant slides or sticks as a whole, whichever is nearer, so that the force that
/// is locked in is off by R'' (x dt)^2/2, x <= 1/2, at most R'' dt^2/8, until all slides again. All rings change at
/// once; where they change one after the other such errors cancel, and differences between steps show what is left.
/// Those between steps of equal x show nothing here. R'' dt^2 is the second difference of R over the first two steps
/// that stick.
struct SlidingEnds {
  double force = 0;       ///< largest error of F_x
  double mean_force = 0;  ///< of its mean over the period
  double work = 0;        ///< of oint F_x du_x
};

/// along: moves of the indenter in the steps of the last period. repeats: whether the first step follows the last one.
SlidingEnds sliding_ends(double friction_coefficient, const NormalHistory& normal, const FrictionHistory& friction,
                         const Eigen::VectorXd& along, bool repeats);

}  // namespace fretval::fem
