#pragma once

#include "mdr/rheology/fractional_zener.h"
#include "mdr/rheology/prony_body.h"
#include "mdr/rheology/rheology.h"

namespace fretval::mdr {

/// Shift factor a_T of the relaxation times between the reference temperature T_r and the temperature T:
///
///   log10 a_T = -c1 (T - T_r)/(c2 + T - T_r)
///
/// Source: Williams, Landel and Ferry, Journal of the American Chemical Society 77 (1955) 3701. Valid for
/// thermorheologically simple bodies, from the glass transition to about 100 K above it. c1 > 0 is a number, c2 > 0 in
/// K; both temperatures in the same unit, K or degrees Celsius. Throws std::invalid_argument at or below the pole
/// T = T_r - c2, and so close above it that a_T leaves the range of double.
double wlf_shift(double c1, double c2, double reference_temperature, double temperature);

/// The body at the temperature of the shift factor a_T > 0: relaxation times and viscosity multiplied by a_T, moduli
/// unchanged (no vertical shift), so that G(omega) becomes G(a_T omega).
PronyBody shifted(const PronyBody& body, double shift_factor);
FractionalZener shifted(const FractionalZener& body, double shift_factor);
Rheology shifted(const Rheology& body, double shift_factor);

}  // namespace fretval::mdr
