#pragma once

#include "comparison/reference/mdr_case.h"

namespace fretval {

/// mdr_normal_response over a layer (MdrCase::layer).
mdr::NormalResponse layer_normal_response(const MdrCase& mdr);

/// Of an unworn indenter that oscillates: springs that the layer couples, stepped in time, with so many times the usual
/// springs and steps. Throws mdr::GrossSlip, and otherwise as mdr::coupled_response.
mdr::SteppedForcedResponse layer_response(const MdrCase& mdr, int times);

/// MdrAnswer::worn_radius over a layer, m; deepest: largest indentation, m. Empty: nothing sticks, or forces, of whose
/// limiting state the indentation is another.
std::optional<double> layer_worn_radius(const MdrCase& mdr, const std::optional<double>& shakedown_radius,
                                        double deepest);

}  // namespace fretval
