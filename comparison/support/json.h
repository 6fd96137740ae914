#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

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

}  // namespace fretval
