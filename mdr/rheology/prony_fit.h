#pragma once

#include <optional>
#include <vector>

#include "mdr/rheology/modulus_table.h"
#include "mdr/rheology/prony_body.h"

namespace fretval::mdr {

struct PronyFitOptions {
  std::optional<int> branches_per_decade;  ///< 1 to 32; chosen by the held-out misfit unless given
  std::vector<double> branch_times;        ///< tau_i in s, to be used instead if not empty; positive and different
  bool dashpot = false;                    ///< whether a viscosity may be fitted too
  bool storage_alone = false;              ///< G' is fitted, and G'' left out; misfits are of both
};

/// Misfits are relative, (fit - measured)/measured, of G' and G'' alike.
struct PronyFit {
  PronyBody body;
  int n_branches_offered;  ///< to the fit; those that it does not use are dropped from the body
  double residual;         ///< root mean square misfit
  double worst;            ///< largest misfit, without its sign
  double worst_frequency;  ///< where that is, in Hz
  double held_out;         ///< root mean square misfit at frequencies left out of the fit
};

/// Prony body that fits a table of measured moduli:
///
///   min sum_j ((G'(omega_j) - G'_j)/G'_j)^2 + ((G''(omega_j) - G''_j)/G''_j)^2  over G0, G_i, eta >= 0
///
/// Branch times are fixed, equally spaced in log time from 1/omega_max to 1/omega_min, so the problem is convex (see
/// non_negative_least_squares); that no modulus is negative keeps noise from bringing in oscillating ones.
///
/// For held_out every fifth frequency is left out in turn. The number of branches per decade is doubled from 1, up to
/// 32, as long as that lowers the held-out misfit by over 5 %.
///
/// The fit speaks for the measured range only: G0 contains whatever relaxes more slowly than was measured, and beyond
/// the range the body is elastic (or viscous with a dashpot).
///
/// Throws std::invalid_argument for an invalid table, for fewer than 5 frequencies, and if the best G0 is zero: then
/// the table shows no relaxed plateau, and a body without one would flow.
PronyFit fit_prony(const ModulusTable& table, const PronyFitOptions& options = {});

}  // namespace fretval::mdr
