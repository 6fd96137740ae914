#pragma once

#include <string_view>

namespace fretval::mdr {

/// Guards at the door of every public function: a bad argument ends in std::invalid_argument that names the quantity,
/// its value and what would be valid, never in a silent NaN.

/// Throws unless value is finite and > 0.
void require_positive(std::string_view quantity, double value);

/// Throws unless value is finite and >= 0.
void require_non_negative(std::string_view quantity, double value);

/// Throws unless value is finite and lower <= value <= upper.
void require_within(std::string_view quantity, double value, double lower, double upper);

/// Throws unless value is finite.
void require_finite(std::string_view quantity, double value);

/// Throws std::invalid_argument("<quantity> = <value>: <what would be valid>").
[[noreturn]] void reject(std::string_view quantity, double value, std::string_view valid);

}  // namespace fretval::mdr
