#pragma once

#include <Eigen/Core>

#include "mdr/springs/spring_bed.h"

namespace fretval::mdr {

/// Largest path of slip that counts as none, over the largest tangential displacement: of a spring that has never
/// slipped, and of a spring in a period once it has shaken down.
constexpr double never_slipped = 1e-11, shaken_down = 1e-6;

/// g(c) in m from the outermost of the springs that stick, counted from the axis: its depth and its least friction
/// margin over its stiffness, `g + margin/(3 mu/2)`. margin: least `(3 mu/2) normal_load -+ tangential_load` in m,
/// slip_path in m, both per spring; allowed: slip that counts as stick. Where no spring sticks, it is read at the
/// innermost one, and is not more than its depth.
double stick_depth(const SpringBed& bed, double mu, const Eigen::ArrayXd& margin, const Eigen::ArrayXd& slip_path,
                   double allowed);

}  // namespace fretval::mdr
