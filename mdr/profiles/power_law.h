#pragma once

namespace fretval::mdr {

/// f(r) = b r^n, whose image is g(x) = kappa_n b |x|^n with kappa_n = (sqrt(pi)/2) n Gamma(n/2)/Gamma((n+1)/2).
/// Source: paper, equation (3) applied to a power law; parabola kappa_2 = 2, cone kappa_1 = pi/2.
/// The functions below are those of mdr/profiles/profile.h, which documents them and checks their arguments.
struct PowerLaw {
  double coefficient;        ///< b in m^(1-n)
  double exponent;           ///< n, between 0.5 and 20
  double image_coefficient;  ///< kappa_n b
};

/// kappa_n, the ratio g(r)/f(r) of a power law. n positive.
double transform_factor(double exponent);

double shape(const PowerLaw& profile, double r);
double shape_slope(const PowerLaw& profile, double r);
double transform(const PowerLaw& profile, double x);
double transform_slope(const PowerLaw& profile, double x);
double transform_integral(const PowerLaw& profile, double x);
double inverse_transform(const PowerLaw& profile, double depth);
double abel_slope_integral(const PowerLaw& profile, double r, double a);
double abel_depth_integral(const PowerLaw& profile, double lower, double upper, double r);

}  // namespace fretval::mdr
