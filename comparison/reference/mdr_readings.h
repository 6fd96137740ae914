#pragma once

#include <nlohmann/json_fwd.hpp>

#include "comparison/quantities/reading.h"
#include "comparison/reference/mdr_answer.h"

namespace fretval {

/// What MDR says of each quantity, those without a value as well that every case could have. Springs that were stepped
/// in time tell by how much they may be off.
Readings readings_of(const MdrAnswer& answer);

/// What is compared with finite elements on the same indenter: these and, of a limiting profile, what MDR expects where
/// nothing wears any more: no slip inside, no force outside, the flank touches at the largest indentation.
Readings compared_readings_of(const MdrAnswer& answer);

/// The "mdr" object of result.json. SI units; null where nothing sticks.
nlohmann::ordered_json to_json(const MdrAnswer& answer);

/// contact_radius: m, unworn.
Scales scales_of(const MdrAnswer& answer, double contact_radius);

}  // namespace fretval
