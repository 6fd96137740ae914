#pragma once

#include <nlohmann/json_fwd.hpp>

#include "comparison/quantities/reading.h"

namespace fretval {

/// Adds the value of each reading under the name of its quantity, null for none, in the order in which people ask for
/// them; `uncertainty` and `absent` hold, by quantity, the uncertainties and why there is no value.
void add_readings(const Readings& readings, nlohmann::ordered_json& json);

/// The reading of a quantity in the "fe" or "mdr" of a result.json, or of `fretval mdr --json`. Empty: it is not there.
std::optional<Reading> stored_reading(const nlohmann::ordered_json& method, Quantity quantity);

}  // namespace fretval
