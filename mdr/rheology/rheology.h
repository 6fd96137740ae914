#pragma once

#include <complex>
#include <variant>

#include "mdr/rheology/fractional_zener.h"
#include "mdr/rheology/prony_body.h"

namespace fretval::mdr {

/// Any linear viscoelastic body that the frequency domain can describe. Both stick radii and the limiting profile need
/// no more; histories in time need a PronyBody.
using Rheology = std::variant<PronyBody, FractionalZener>;

/// Complex modulus G(omega) in Pa at the angular frequency omega >= 0 in rad/s.
std::complex<double> complex_modulus(const Rheology& body, double omega);

/// G0 = G'(0) in Pa.
double relaxed_modulus(const Rheology& body);

/// G(omega)/G0: magnitude and phase of an oscillating force over the relaxed response to the same displacement.
/// Accurate to roundoff for any omega tau.
std::complex<double> complex_modulus_ratio(const Rheology& body, double omega);

/// rho = |G(omega)|/G0 >= 1, the factor by which the oscillating part of a force exceeds the relaxed response; paper
/// equations (20) to (27).
double modulus_ratio(const Rheology& body, double omega);

}  // namespace fretval::mdr
