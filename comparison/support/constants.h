#pragma once

#include "mdr/support/constants.h"

namespace fretval {

using mdr::pi;

constexpr double degree = pi / 180, degrees_per_radian = 180 / pi;

}  // namespace fretval
