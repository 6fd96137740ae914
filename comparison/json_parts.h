#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "comparison/resolution.h"

namespace fretval {

/// Null where there is no value.
template <class Value>
nlohmann::ordered_json or_null(const std::optional<Value>& value) {
  return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
}

/// Null for what is not finite.
nlohmann::ordered_json or_null(double value);

/// Likewise, or where there is no value.
nlohmann::ordered_json or_null(const std::optional<double>& value);

/// Null for an empty text.
nlohmann::ordered_json or_null(const std::string& text);

/// Rings, degree, growth, far_radius, steps_per_cycle, ramp_cycles, periodicity; focus if there is one.
nlohmann::ordered_json resolution_json(const Resolution& resolution);

/// Inner and outer radius and ring.
nlohmann::ordered_json focus_json(const Focus& focus);

/// An object with those of each quantity.
nlohmann::ordered_json focus_json(const std::map<std::string, Focus>& focus);

}  // namespace fretval
