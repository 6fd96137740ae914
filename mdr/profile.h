#pragma once

namespace fretval::mdr {

/// Axisymmetric indenter with a power-law shape and its one-dimensional MDR image.
///
///   f(r) = b r^n,    g(x) = kappa_n b |x|^n,    kappa_n = (sqrt(pi)/2) n Gamma(n/2) / Gamma((n+1)/2)
///
/// Source: paper, equation (3) applied to a power law; parabola kappa_2 = 2, cone kappa_1 = pi/2.
/// Made by the factories below, which check their arguments.
struct Profile {
  double coefficient;  ///< b in m^(1-n)
  double exponent;     ///< n, between 0.5 and 20
};

/// f = r^2 / (2 R). Radius of curvature R in m, positive.
Profile parabola(double radius);

/// f = r tan(theta). Angle theta between generatrix and surface in rad, 0 < theta < pi/2.
Profile cone(double slope_angle);

/// f = b r^n. b in m^(1-n), positive; n between 0.5 and 20. For n < 1 the tip is a cusp of infinite slope.
Profile power_law(double coefficient, double exponent);

/// kappa_n, the ratio g(r)/f(r) of a power law. n positive.
double transform_factor(double exponent);

/// Height f(r) in m at r >= 0 in m.
double shape(const Profile& profile, double r);

/// Slope f'(r) at r >= 0; +infinity at r = 0 for n < 1.
double shape_slope(const Profile& profile, double r);

/// One-dimensional image g(x) = |x| int_0^|x| f'(r)/sqrt(x^2-r^2) dr in m, paper equation (3). Any finite x in m.
double transform(const Profile& profile, double x);

/// Derivative g'(x) at x >= 0; +infinity at x = 0 for n < 1.
double transform_slope(const Profile& profile, double x);

/// The x >= 0 with g(x) = depth, which is the contact radius of an elastic body at this indentation.
/// depth >= 0 in m; 0 gives 0; a negative depth throws std::invalid_argument.
double inverse_transform(const Profile& profile, double depth);

}  // namespace fretval::mdr
