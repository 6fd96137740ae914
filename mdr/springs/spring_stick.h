#pragma once

#include <Eigen/Core>

#include "mdr/springs/spring_bed.h"

namespace fretval::mdr {

/// Shares of the largest tangential displacement: of a path of slip what counts as none, and the last creep of a spring
/// that has shaken down.
constexpr double never_slipped = 1e-11, shaken_down = 1e-6;

/// g(c) in m from the outermost of the springs that stick, counted from the axis: its depth and its least friction
/// margin over its stiffness, `g + margin/(3 mu/2)`. margin: least `(3 mu/2) normal_load -+ tangential_load` in m,
/// slip_path in m, both per spring; allowed: slip that counts as stick. Where none sticks, from the innermost one: not
/// more than its depth.
double stick_depth(const SpringBed& bed, double mu, const Eigen::ArrayXd& margin, const Eigen::ArrayXd& slip_path,
                   double allowed);

}  // namespace fretval::mdr
