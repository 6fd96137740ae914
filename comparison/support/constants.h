#pragma once

namespace fretval {

inline constexpr double pi = 3.14159265358979323846;

}  // namespace fretval
