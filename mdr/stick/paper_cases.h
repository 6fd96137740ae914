#pragma once

#include "mdr/motion/motion.h"
#include "mdr/rheology/rheology.h"

namespace fretval::mdr {

/// The paper's own equations for the depth g(c) of the first-slip criterion, in m. They are the second opinion on
/// stick_depths() of mdr/stick/stick_radius.h and say the same in more cases.
///
/// Misprints of the paper, put right here: (23) has mu in the denominator of k, which contradicts (20); the text before
/// (21) says |cos(Omega + phi1)| where (20) has phi0. In (20) Omega = omega t + phi1, not phi0.
///
/// modulus_ratio: rho = |G(omega)|/G'(0) >= 1 at the common frequency; mu: coefficient of friction, positive.
/// Where a modulus ratio is given, only indentation, amplitudes and phase of the motion enter. Bad arguments throw
/// std::invalid_argument.

/// Right-hand side of (18) at the time t in s, which g(c) must not exceed at any time:
///   d0 - (1/G'(0)) [(2 u_x0/(3 mu)) |G' cos(omega t + phi0) - G'' sin(omega t + phi0)|
///                   - Delta d (G' cos(omega t) - G'' sin(omega t))]
/// Needs a phase and equal frequencies.
double paper_no_slip_depth_at_time(const Rheology& body, double mu, const Motion& motion, double time);

/// (19): the least of (18) over a cycle, to 1e-13 of the lengths that enter. It is found as the maximum of two
/// trigonometric polynomials, one for each sign of the tangential force, without use of (20).
double paper_least_no_slip_depth(const Rheology& body, double mu, const Motion& motion);

/// Right-hand side of (20) at the angle Omega = omega t + phi1 in rad, tan(phi1) = G''/G':
///   d0 - rho [A |cos(Omega + phi0)| - Delta d cos(Omega)]
/// Needs a phase.
double paper_no_slip_depth(double modulus_ratio, double mu, const Motion& motion, double angle);

/// (21): phase not fixed, g(c) = d0 - rho [A + Delta d], A = 2 u_x0/(3 mu).
double paper_unlocked_depth(double modulus_ratio, double mu, const Motion& motion);

/// (22): phase 90 degrees, g(c) = d0 - rho sqrt(A^2 + Delta d^2).
double paper_quadrature_depth(double modulus_ratio, double mu, const Motion& motion);

/// (23): k = 3 mu Delta d/(2 u_x0), mu in the numerator. Needs a tangential amplitude that is not 0.
double paper_amplitude_ratio(double mu, const Motion& motion);

/// The four candidates for g(c), each of which is admissible in some cases only.
struct PaperCandidates {
  double c1;  ///< (24): d0 - (Delta d rho/k) sqrt(k^2 - 2 k cos(phi0) + 1)
  double c2;  ///< (25): d0 - (Delta d rho/k) sqrt(k^2 + 2 k cos(phi0) + 1)
  double c3;  ///< (26): d0 + Delta d rho sin(phi0)
  double c4;  ///< (27): d0 - Delta d rho sin(phi0)
};

/// (24) to (27). Needs a phase and both amplitudes positive, otherwise k is not defined.
PaperCandidates paper_candidates(double modulus_ratio, double mu, const Motion& motion);

/// The smallest of the admissible candidates by the rules 1 to 3 that follow (27), any fixed phase. The singular ones,
/// c3 and c4, never decide.
double paper_case_list_depth(double modulus_ratio, double mu, const Motion& motion);

}  // namespace fretval::mdr
