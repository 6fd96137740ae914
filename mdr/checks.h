#pragma once

#include <string>

namespace fretval::mdr {

/// Guards at the door of every public function: a bad argument ends in std::invalid_argument that names the quantity,
/// its value and what would be valid, never in a silent NaN.

/// Throws unless value is finite and > 0.
void require_positive(const std::string& quantity, double value);

/// Throws unless value is finite and >= 0.
void require_non_negative(const std::string& quantity, double value);

/// Throws unless value is finite and lower <= value <= upper.
void require_within(const std::string& quantity, double value, double lower, double upper);

/// Throws unless value is finite.
void require_finite(const std::string& quantity, double value);

/// Throws std::invalid_argument("<quantity> = <value>: <what would be valid>").
[[noreturn]] void reject(const std::string& quantity, double value, const std::string& valid);

}  // namespace fretval::mdr
