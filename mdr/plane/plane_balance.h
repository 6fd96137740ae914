#pragma once

#include <Eigen/Core>

namespace fretval::mdr {

/// Springs in a step whose indenter goes by u along the surface: each bears what it would bear if it stuck,
/// (x, y) + stiffness u, or where that is more than `most` a force of that size in its direction. Loads in m.
struct PlaneLines {
  Eigen::ArrayXd width;  ///< of the springs, m
  Eigen::ArrayXd x, y, most;
  double stiffness;
};

/// Share that each spring keeps of the load (x, y) in m that it would bear if it stuck: 1, or less where that load
/// exceeds `most`.
Eigen::ArrayXd shares_within(const Eigen::ArrayXd& most, const Eigen::ArrayXd& x, const Eigen::ArrayXd& y);

/// The displacement u in m at which the springs bear a given sum(width * load) in m^2, which has to be smaller than
/// that of `most`. The sum is the gradient of a convex function of u, and u is found by Newton's method, whose steps
/// are halved until the remainder falls, to 1e-12 of the sum of `most`. Throws std::runtime_error after 200 steps.
Eigen::Vector2d way_for_forces(const Eigen::Vector2d& sum, const PlaneLines& lines);

}  // namespace fretval::mdr
