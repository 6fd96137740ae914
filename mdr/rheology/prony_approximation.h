#pragma once

#include "mdr/rheology/fractional_zener.h"
#include "mdr/rheology/prony_body.h"

namespace fretval::mdr {

/// A Prony body that stands for a fractional Zener body in time.
struct PronyApproximation {
  PronyBody body;
  double worst;  ///< largest |G_prony - G|/|G| over the range of frequencies
};

/// The approximation has the G0 of the body, and four branches per decade from ten times slower to ten times faster
/// than the range, whose moduli are the non-negative least squares of the relative misfit of G(omega) over the range.
/// Without the branches slower than the range the slow end of the spectrum would be missing from the storage modulus.
/// lowest_frequency < highest_frequency in Hz, positive; std::invalid_argument otherwise.
PronyApproximation prony_approximation(const FractionalZener& body, double lowest_frequency, double highest_frequency);

}  // namespace fretval::mdr
