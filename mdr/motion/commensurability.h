#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace fretval::mdr {

/// A ratio of two frequencies in lowest terms.
struct FrequencyRatio {
  int numerator;    ///< p
  int denominator;  ///< q
};

/// Largest p, q and order of a frequency within a group that counts as commensurate.
///
/// Beyond it two oscillations are treated as incommensurate, whose common trajectory fills a torus. What that costs:
/// when -N is largest, the phases of T lie 2 pi/q apart, so one of them is within pi/q of its own maximum, and
///   0 <= (A + D) - max_t[A cos(p theta + phi) + D cos(q theta)] <= (pi^2/2) A D/(A p^2 + D q^2),
/// at most 5e-8 of the smaller amplitude for p, q > 10^4, and 5e-8 D for p > 10^4 alone. The stick radius errs to the
/// small side.
inline constexpr int largest_order = 10000;

/// p/q nearest to the ratio, found as a continued fraction; empty: none with p, q <= largest_order is within a relative
/// 1e-12. That is far above the roundoff of an input such as 1.0/3 or of a conversion to rad/s, and far below the
/// distance 1e-8 of two such fractions. Oscillations that drift apart by less stay locked for 10^11 cycles or more.
/// ratio positive, otherwise std::invalid_argument.
std::optional<FrequencyRatio> frequency_ratio(double ratio);

/// Frequencies that are whole multiples of one base frequency, orders without a common divisor.
struct CommensurateGroup {
  double base_frequency;             ///< Hz
  std::vector<std::size_t> members;  ///< places in the list of frequencies
  std::vector<int> orders;           ///< frequency/base_frequency, as many as members
};

/// Splits frequencies in Hz, all positive, into groups of commensurate ones; a frequency that would raise an order
/// above largest_order starts a group of its own. The phases of different groups count as independent of each other,
/// exact for two groups. Among three or more a relation such as f3 = f1 + f2 may tie them, which is not looked for:
/// maxima taken group by group are then upper bounds, and stick radii made from them lower bounds.
/// Throws std::invalid_argument for bad frequencies.
std::vector<CommensurateGroup> commensurate_groups(const std::vector<double>& frequencies);

}  // namespace fretval::mdr
