#pragma once

namespace fretval::mdr {

/// Flat face of radius b with a flank that breaks or bends off from it:
///
///   f(r) = 0 for r <= b,    f(r) = s (r - b) + (r - b)^2/(2 R) beyond
///   g(x) = x [s phi + (b/R) (tan(phi) - phi)],    phi = arccos(b/x),    x > b
///
/// s = 0: flat punch with a rounded edge of radius R; s = b/R: sphere of radius R worn or cut down to a flat of radius
/// b; 1/R = 0: truncated cone. Source: paper, equation (3).
/// The functions below are those of mdr/profiles/profile.h, which documents them and checks their arguments.
struct FlatFaced {
  double flat_radius;  ///< b in m, positive
  double edge_slope;   ///< s
  double curvature;    ///< 1/R in 1/m
};

double shape(const FlatFaced& profile, double r);
double shape_slope(const FlatFaced& profile, double r);
double transform(const FlatFaced& profile, double x);
double transform_slope(const FlatFaced& profile, double x);
double transform_integral(const FlatFaced& profile, double x);
double inverse_transform(const FlatFaced& profile, double depth);
double abel_slope_integral(const FlatFaced& profile, double r, double a);
double abel_depth_integral(const FlatFaced& profile, double lower, double upper, double r);

}  // namespace fretval::mdr
