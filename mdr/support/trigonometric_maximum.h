#pragma once

#include <vector>

namespace fretval::mdr {

/// One term a cos(n theta + phi) of a trigonometric polynomial.
struct TrigonometricTerm {
  double amplitude;  ///< a, any sign and unit
  int order;         ///< n >= 0; 0 makes the term a constant
  double phase;      ///< phi in rad
};

struct TrigonometricMaximum {
  double value;  ///< in the unit of the amplitudes
  double angle;  ///< theta in [0, 2 pi) that reaches it
};

/// Global maximum of P(theta) = sum_k a_k cos(n_k theta + phi_k), with a guarantee: no value of P exceeds the one
/// returned by more than 1e-13 sum |a_k|, whatever the number, height and width of the peaks.
///
/// Branch and bound: on a cell of half width h about m, with M3 = sum |a_k| n_k^3,
///   P(m+x) <= max over |x| <= h of [P(m) + P'(m) x + P''(m) x^2/2] + M3 h^3/6;
/// a cell goes once this cannot beat the best value found, which Newton's method polishes.
/// The cost grows in proportion to the largest order times the number of terms; 2 ms for two terms of order 10^4.
/// No terms: the value is 0. Throws std::invalid_argument for a negative order and for numbers that are not finite.
TrigonometricMaximum trigonometric_maximum(const std::vector<TrigonometricTerm>& terms);

}  // namespace fretval::mdr
