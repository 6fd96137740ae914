#pragma once

#include <complex>

namespace fretval::mdr {

/// Spring parallel to a spring and a spring-pot in series: the fractional Zener body, with a broad loss peak from few
/// parameters. For order = 1 it is the standard solid.
///
///   G(omega) = G0 + G1 (i omega tau)^alpha / (1 + (i omega tau)^alpha)
///
/// Source: Bagley and Torvik, Journal of Rheology 27 (1983) 201; Mainardi, Fractional Calculus and Waves in Linear
/// Viscoelasticity (2010), chapter 3.
struct FractionalZener {
  double relaxed_modulus;  ///< G0 = G'(0) in Pa, positive
  double branch_modulus;   ///< G1 in Pa, not negative
  double branch_time;      ///< tau in s, positive
  double order;            ///< alpha, 0 < alpha <= 1
};

/// Throws std::invalid_argument unless the body is as described above.
void validate(const FractionalZener& body);

/// G(omega) in Pa at the angular frequency omega >= 0 in rad/s, accurate to roundoff for any omega tau.
std::complex<double> complex_modulus(const FractionalZener& body, double omega);

}  // namespace fretval::mdr
