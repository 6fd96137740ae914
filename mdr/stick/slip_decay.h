#pragma once

#include <optional>

#include "mdr/rheology/prony_body.h"

namespace fretval::mdr {

/// Factor per period T by which slip dies out in an element that shakes down, of a body with branches and without a
/// dashpot. In the end such an element slips once a period, at the instant at which its friction limit is closest, by
/// s_n, and each time just as far that it stays within the limit:
///
///   sum_(k <= n) s_k G((n - k) T) = const   ->   s_n ~ lambda^n,   G0 + sum_i G_i (lambda - 1)/(lambda - q_i) = 0,
///   q_i = exp(-T/tau_i)
///
/// with its largest root, between the largest q_i and 1; of one branch lambda = (G0 q + G1)/(G0 + G1). lambda is the
/// same for all elements, motions and profiles, under displacements and forces, and in a continuum as well, where all
/// tractions have the one G(t).
///
/// Empty: without branches, where slip ends at once, and with a dashpot, which lets an element slip as far as there is
/// time while its limit is exceeded: what is left of that, E, falls by E^(3/2) in a period, so slip dies out like
/// n^(-3), with no factor. period in s, positive. Throws std::invalid_argument.
std::optional<double> slip_decay(const PronyBody& body, double period);

}  // namespace fretval::mdr
