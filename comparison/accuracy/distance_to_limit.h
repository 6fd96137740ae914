#pragma once

#include <Eigen/Dense>
#include <vector>

#include "comparison/reference/mdr_wear.h"

namespace fretval {

/// A profile in the plane of r/a and f/d_max, a the unworn contact radius and d_max the largest indentation, as a chain
/// of points with r rising.
using ProfileChain = std::vector<Eigen::Vector2d>;

/// The limiting profile out to a radius, in m, dense enough to measure distances of 1e-6 from it.
ProfileChain chain_of(const WearLimit& limit, double contact_radius, double end);

/// Largest distance of the points of a profile from the chain of another. It is the distance in the plane, not in
/// height: a worn profile is vertical at the stick radius, where a radius that is off by 1e-4 a stands for 9e-3 d_max.
double distance_between(const ProfileChain& points, const ProfileChain& chain);

}  // namespace fretval
