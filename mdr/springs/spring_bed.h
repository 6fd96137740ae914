#pragma once

#include <Eigen/Core>
#include <functional>

#include "mdr/profiles/profile.h"

namespace fretval::mdr {

/// The springs of the one-dimensional foundation on one side of the axis, x > 0; the other side mirrors them.
struct SpringBed {
  Eigen::ArrayXd position;  ///< x of the middle of each spring's interval in m, rising
  Eigen::ArrayXd width;     ///< length of the interval in m
  Eigen::ArrayXd depth;     ///< mean of g over the interval in m
  /// What tells zones of coupled springs: depth, and within a flat face zone_depth() of mdr/profiles/zone_depth.h.
  Eigen::ArrayXd zone_depth = {};
};

/// Weights w of the loads per length q in the pressure on the axis, p(0) = -(1/pi) int q'(x)/x dx = sum(w q), for
/// springs of equal width: of second order where g ~ x^n, n >= 2, of order n - 1 below, without bound for a cone.
Eigen::ArrayXd axis_weights(const SpringBed& bed);

/// n equal intervals on [0, outer_radius]. With the mean of g the load of all springs in contact is exact.
/// Throws std::invalid_argument for bad arguments and when a table ends before outer_radius.
SpringBed spring_bed(const Profile& profile, double outer_radius, Eigen::Index n_springs);

/// Springs under any image g(x), taken in the middle of the intervals; for worn profiles.
SpringBed spring_bed(const std::function<double(double)>& g, double outer_radius, Eigen::Index n_springs);

}  // namespace fretval::mdr
