#pragma once

#include <nlohmann/json_fwd.hpp>

#include "comparison/quantities/reading.h"
#include "comparison/reference/mdr_answer.h"

namespace fretval {

/// Values of the quantities by MDR, in SI units; of those that every case could have also the ones without a value.
/// Springs that were stepped in time have an uncertainty.
Readings readings_of(const MdrAnswer& answer);

/// The readings that are compared with finite elements on the same indenter. Of a limiting profile these contain what
/// MDR expects where nothing wears any more: no slip inside, no force outside, the flank touches at the largest
/// indentation.
Readings compared_readings_of(const MdrAnswer& answer);

/// The "mdr" object of result.json. SI units; null where nothing sticks.
nlohmann::ordered_json to_json(const MdrAnswer& answer);

/// Scales of the differences from an answer of MDR. contact_radius: m, of the unworn contact.
Scales scales_of(const MdrAnswer& answer, double contact_radius);

}  // namespace fretval
