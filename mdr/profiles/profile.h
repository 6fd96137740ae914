#pragma once

#include <variant>
#include <vector>

#include "mdr/profiles/flat_faced.h"
#include "mdr/profiles/power_law.h"
#include "mdr/profiles/profile_table.h"
#include "mdr/profiles/sphere.h"

namespace fretval::mdr {

/// Axisymmetric indenter f(r) and its one-dimensional MDR image g(x), with f(0) = g(0) = 0 and both rising outwards.
///
///   g(x) = |x| int_0^|x| f'(r)/sqrt(x^2-r^2) dr      paper equation (3)
///   f(r) = (2/pi) int_0^r g(x)/sqrt(r^2-x^2) dx      paper equation (4)
///
/// Made by the factories below, which check their arguments. Every kind has its transforms in closed form.
/// All functions throw std::invalid_argument for a coordinate that is negative, not finite, or beyond the end of the
/// profile: the last row of a table, the radius of a sphere.
using Profile = std::variant<PowerLaw, FlatFaced, ProfileTable, Sphere>;

/// f = r^2/(2 R). Radius of curvature R in m, positive.
Profile parabola(double radius);

/// f = R - sqrt(R^2 - r^2) for r <= R. Radius R in m, positive.
Profile sphere(double radius);

/// f = r tan(theta). Angle theta between generatrix and surface in rad, 0 < theta < pi/2.
Profile cone(double slope_angle);

/// f = b r^n. b in m^(1-n), positive; n between 0.5 and 20. For n < 1 the tip is a cusp of infinite slope.
Profile power_law(double coefficient, double exponent);

/// Flat punch of radius b with a rounded edge of radius R, both in m and positive: f = (r - b)^2/(2 R) for r > b.
Profile rounded_flat(double flat_radius, double edge_radius);

/// Sphere of radius R worn or cut down to a flat of radius b, both in m and positive: f = (r^2 - b^2)/(2 R) for r > b.
Profile truncated_sphere(double radius, double flat_radius);

/// Profile of measured points (r, f) in m: through them, or with noise > 0, the standard deviation of their heights in
/// m, the convex profile that fits them; see mdr/profiles/profile_table.h for what is asked of them.
Profile tabulated(const std::vector<double>& r, const std::vector<double>& f, double noise = 0);

/// A profile of any shape through points (r, f) in m, see profile_table_as_it_is: where its image falls, MDR does not
/// hold. Of such a profile only the height, its slope and the image itself may be asked for; all else throws
/// std::invalid_argument.
Profile tabulated_as_it_is(const std::vector<double>& r, const std::vector<double>& f);

/// Where the image falls, from the axis outwards; empty: MDR holds.
std::vector<FallOfImage> falls_of_image(const Profile& profile);

/// Where the profile ends, in m: the last row of a table, the radius of a sphere, infinity for all others.
double end_radius(const Profile& profile);

/// Height f(r) in m at r >= 0 in m.
double shape(const Profile& profile, double r);

/// Slope f'(r) at r >= 0; +infinity at r = 0 for a power law with n < 1.
double shape_slope(const Profile& profile, double r);

/// One-dimensional image g(x) in m. Any finite x in m.
double transform(const Profile& profile, double x);

/// Derivative g'(x) at x >= 0; +infinity where the profile has a kink that turns up, and at x = 0 for n < 1.
double transform_slope(const Profile& profile, double x);

/// Where g is not smooth inside the contact: the edge of a flat face. Tables are smooth enough to be integrated as one.
std::vector<double> transform_kinks(const Profile& profile);

/// int_0^x g(x') dx' in m^2 at x >= 0.
double transform_integral(const Profile& profile, double x);

/// The x >= 0 with g(x) = depth, which is the contact radius of an elastic body at this indentation; the flat radius
/// for depth 0 and a flat face. depth >= 0 in m, for a table not above g of the last row, for a sphere not above its
/// largest_depth().
double inverse_transform(const Profile& profile, double depth);

/// int_r^a g'(x)/sqrt(x^2-r^2) dx for 0 <= r <= a, the Abel integral behind every pressure. +infinity at r = 0 for a
/// tip that is not horizontal (n <= 1), and at r = b under a flat face whose edge is sharp.
double abel_slope_integral(const Profile& profile, double r, double a);

/// int g(x)/sqrt(r^2-x^2) dx in m from lower to upper, 0 <= lower <= upper <= r, the Abel integral behind surface
/// displacements and worn depths. Only upper has to lie on a profile that ends.
double abel_depth_integral(const Profile& profile, double lower, double upper, double r);

}  // namespace fretval::mdr
