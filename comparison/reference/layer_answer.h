#pragma once

#include "comparison/reference/mdr_answer.h"

namespace fretval {

/// Why MDR for layers cannot be asked, and the entry that asks for it; empty: it can.
std::string why_not_on_layer(const Case& input);

/// mdr_normal_response over a layer (MdrCase::layer).
mdr::NormalResponse layer_normal_response(const MdrCase& mdr);

/// mdr_answer over a layer, of an unworn indenter that oscillates: springs that the layer couples, stepped in time,
/// with so many times the usual springs and steps. Neither decay of slip nor cycles to shakedown, which are of springs
/// that do not know of each other.
MdrAnswer layer_answer(const MdrCase& mdr, const mdr::NormalResponse& normal, int times);

/// What MDR says of a half-space in the place of the body of a case, without the cycle.
MdrAnswer half_space_answer(const Case& input);

}  // namespace fretval
