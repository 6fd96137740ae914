#pragma once

#include <Eigen/Dense>

#include "mdr/stick/limiting_profile.h"

namespace fretval {

/// Largest distance of the points (r, f) of a profile, in m, from the curve of a limiting one, in the plane of r/a and
/// f/d_max, a the unworn contact radius. The curve is vertical at the stick radius: a stick radius that is off by
/// 1e-4 a is a distance of 1e-4, though heights differ by 9e-3 d_max there.
double distance_to_limit(const mdr::LimitingProfile& limit, double contact_radius, const Eigen::VectorXd& r,
                         const Eigen::VectorXd& f);

}  // namespace fretval
