#pragma once

#include <limits>

namespace fretval::fem {

inline constexpr double pi = 3.14159265358979323846;
inline constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace fretval::fem
