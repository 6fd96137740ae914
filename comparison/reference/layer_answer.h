#pragma once

#include "comparison/reference/mdr_values.h"

namespace fretval {

/// mdr_normal_response over a layer (MdrCase::layer).
mdr::NormalResponse layer_normal_response(const MdrCase& mdr);

/// mdr_answer over a layer, of an unworn indenter that oscillates: springs that the layer couples, stepped in time,
/// with so many times the usual springs and steps. Neither decay of slip nor cycles to shakedown, which are of springs
/// that do not know of each other.
MdrAnswer layer_answer(const MdrCase& mdr, const mdr::NormalResponse& normal, int times);

}  // namespace fretval
