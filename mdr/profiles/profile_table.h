#pragma once

#include <vector>

#include "mdr/support/piecewise_cubic.h"

namespace fretval::mdr {

/// Where the image of a profile falls outwards, from m to m: there the contact is not one full circle at every
/// indentation, which MDR assumes.
struct FallOfImage {
  double from, to;
};

/// Profile given by points. The height is a piecewise cubic; its image g has exact values and slopes at many nodes
/// (paper (3) piece by piece) and is a Hermite cubic between them, within about 1e-7 of the exact transform
/// of the height for smooth tables of a hundred rows.
/// The functions below are those of mdr/profiles/profile.h, which documents them and checks their arguments.
struct ProfileTable {
  PiecewiseCubic height, height_slope;
  PiecewiseCubic image, image_slope;
  std::vector<FallOfImage> falls = {};  ///< from the axis outwards; not empty: MDR does not hold
};

/// The profile of the points (r, f) in m, whose heights scatter with the standard deviation noise in m.
///
/// noise = 0: the monotone Hermite cubic through the points, with two parabolas where that would bend down between
/// convex rows; at least 4 rows, r[0] = 0, r increasing; f[0] is taken as
/// the height of the tip and subtracted. Throws std::invalid_argument for bad rows, and when the image g falls
/// anywhere: the contact would not be one full circle, which MDR assumes; the message says where. A convex profile
/// never fails.
/// noise > 0: the convex fit of mdr/profiles/convex_fit.h, which says what is asked of the rows and what is refused.
ProfileTable profile_table(const std::vector<double>& r, const std::vector<double>& f, double noise = 0);

/// A table through the points of any profile, grooved, stepped or hollow: its image may fall, and `falls` says where.
/// Heights are counted from the lowest row, wherever that is. Throws std::invalid_argument for bad rows and for a table
/// without a row above the lowest one.
ProfileTable profile_table_as_it_is(const std::vector<double>& r, const std::vector<double>& f);

/// Radius of the last row, where the profile ends.
double end_radius(const ProfileTable& profile);

double shape(const ProfileTable& profile, double r);
double shape_slope(const ProfileTable& profile, double r);
double transform(const ProfileTable& profile, double x);
double transform_slope(const ProfileTable& profile, double x);
double transform_integral(const ProfileTable& profile, double x);
double inverse_transform(const ProfileTable& profile, double depth);
double abel_slope_integral(const ProfileTable& profile, double r, double a);
double abel_depth_integral(const ProfileTable& profile, double lower, double upper, double r);

}  // namespace fretval::mdr
