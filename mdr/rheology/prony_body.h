#pragma once

#include <complex>
#include <vector>

namespace fretval::mdr {

/// Linear viscoelastic shear rheology of an incompressible elastomer: a spring, Maxwell branches and a dashpot, all in
/// parallel.
///
///   G(t) = G0 + sum_i G_i exp(-t/tau_i) + eta delta(t)
///
/// Made by the factories below, which check their arguments, or by hand and then validate().
struct PronyBody {
  double relaxed_modulus;             ///< G0 = G'(0) in Pa, positive
  std::vector<double> branch_moduli;  ///< G_i in Pa, positive
  std::vector<double> branch_times;   ///< tau_i in s, positive, as many as branch_moduli
  double viscosity = 0;               ///< eta in Pa s, not negative
};

/// G(t) = G0.
PronyBody elastic(double relaxed_modulus);

/// Spring and dashpot in parallel, paper equation (28).
PronyBody kelvin_voigt(double relaxed_modulus, double viscosity);

/// Spring G0 parallel to one Maxwell branch (G1, tau = eta1/G1): the paper's "standard model", equation (29).
PronyBody standard_solid(double relaxed_modulus, double branch_modulus, double branch_time);

/// Generalised Maxwell body with an optional parallel dashpot.
PronyBody prony(double relaxed_modulus, std::vector<double> branch_moduli, std::vector<double> branch_times,
                double viscosity = 0);

/// Throws std::invalid_argument unless the body is as described at PronyBody. A relaxed modulus of zero (Maxwell body)
/// has a message of its own: such a body flows, so no element sticks for good.
void validate(const PronyBody& body);

/// Complex modulus in Pa at the angular frequency omega >= 0 in rad/s:
///   G(omega) = G0 + sum_i G_i (x_i^2 + i x_i)/(1 + x_i^2) + i omega eta,    x_i = omega tau_i
/// For the standard solid this is the correct form of the paper's (29): |G| = sqrt((G1^2 + (G1+G2)^2 x^2)/(1 + x^2)).
std::complex<double> complex_modulus(const PronyBody& body, double omega);

/// Relaxation function G(t) in Pa at the time t >= 0 in s, without the delta function of the dashpot.
double relaxation(const PronyBody& body, double time);

}  // namespace fretval::mdr
