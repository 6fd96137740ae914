#pragma once

#include <Eigen/Core>

#include "mdr/springs/spring_bed.h"

namespace fretval::mdr {

/// Largest path of slip that counts as none, over the largest tangential displacement: of a spring that has never
/// slipped, and of a spring in a period once it has shaken down.
constexpr double never_slipped = 1e-11, shaken_down = 1e-6;

/// Ways that a spring slips in a period: to one side, back, to the other side and back.
constexpr double to_and_fro = 4;

/// How springs slip in the time for which a stick zone is read.
struct SlipOfSprings {
  const Eigen::ArrayXd& path;  ///< length of slip of each spring, m
  double allowed;              ///< that counts as stick, m
  double n_ways;               ///< in how many ways it is made: 1 from rest on, or to_and_fro
};

/// g(c) in m from the outermost of the springs that stick, counted from the axis: its depth and its least friction
/// margin over its stiffness, `g + margin/(3 mu/2)`. margin: least `(3 mu/2) normal_load -+ tangential_load` of each
/// spring, m. Where no spring sticks it is read at the innermost one, whose margin would be as far below 0 as it slips
/// one way.
double stick_depth(const SpringBed& bed, double mu, const Eigen::ArrayXd& margin, const SlipOfSprings& slip);

}  // namespace fretval::mdr
