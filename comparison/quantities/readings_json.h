#pragma once

#include <nlohmann/json_fwd.hpp>

#include "comparison/quantities/reading.h"

namespace fretval {

/// Adds the value of each reading under the name of its quantity, null for none, in the order in which people ask for
/// them; `uncertainty` and `absent`, by quantity, say what they may be off by and why there is none.
void add_readings(const Readings& readings, nlohmann::ordered_json& json);

/// From the "fe" or "mdr" of a result.json, or of `fretval mdr --json`. Empty: it does not say.
std::optional<Reading> stored_reading(const nlohmann::ordered_json& method, Quantity quantity);

}  // namespace fretval
