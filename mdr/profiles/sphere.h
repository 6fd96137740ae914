#pragma once

namespace fretval::mdr {

/// Sphere of radius R with its true arc:
///
///   f(r) = R - sqrt(R^2 - r^2),    g(x) = x artanh(x/R) = (x/2) ln((R+x)/(R-x)),    r, x < R
///
/// g grows without bound towards R, where the profile ends: any depth has a contact inside the sphere.
/// Source: paper, equation (3); Segedin, Prikladnaia Matematika i Mekhanika 21 (1957) 1; Sneddon (1965), the sphere.
/// The functions below are those of mdr/profiles/profile.h, which documents them and checks their arguments.
struct Sphere {
  double radius;  ///< R in m, positive
};

/// Depth in m beyond which the contact radius is R within 1e-6.
double largest_depth(const Sphere& profile);

double shape(const Sphere& profile, double r);
double shape_slope(const Sphere& profile, double r);
double transform(const Sphere& profile, double x);
double transform_slope(const Sphere& profile, double x);
double transform_integral(const Sphere& profile, double x);
double inverse_transform(const Sphere& profile, double depth);
double abel_slope_integral(const Sphere& profile, double r, double a);
double abel_depth_integral(const Sphere& profile, double lower, double upper, double r);

}  // namespace fretval::mdr
