#pragma once

#include "mdr/motion.h"

namespace fretval::mdr {

/// The paper's own equations for the depth g(c) of the first-slip criterion, in m. They are the second opinion on
/// stick_depths() of mdr/stick_radius.h and say the same in more cases.
///
/// modulus_ratio: rho = |G(omega)|/G'(0) >= 1 at the common frequency; mu: coefficient of friction, positive.
/// Of the motion only indentation, amplitudes and phase enter. Bad arguments throw std::invalid_argument.

/// (21): phase not fixed, g(c) = d0 - rho [A + Delta d], A = 2 u_x0/(3 mu).
double paper_unlocked_depth(double modulus_ratio, double mu, const Motion& motion);

/// (22): phase 90 degrees, g(c) = d0 - rho sqrt(A^2 + Delta d^2).
double paper_quadrature_depth(double modulus_ratio, double mu, const Motion& motion);

/// (24) to (27) with the rules 1 to 3 that follow them: the smallest of the admissible candidates, any fixed phase.
/// Departs from the paper in k = 3 mu Delta d/(2 u_x0): (23) prints mu in the denominator, which contradicts (20).
/// Needs a phase and both amplitudes positive, otherwise k is not defined.
double paper_case_list_depth(double modulus_ratio, double mu, const Motion& motion);

}  // namespace fretval::mdr
