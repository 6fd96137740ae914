#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace fretval {

/// The value as JSON; null where there is none.
template <class Value>
nlohmann::ordered_json or_null(const std::optional<Value>& value) {
  return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
}

/// The number as JSON; null if it is not finite.
nlohmann::ordered_json or_null(double value);

/// The number as JSON; null if there is none or it is not finite.
nlohmann::ordered_json or_null(const std::optional<double>& value);

/// The text as JSON; null if it is empty.
nlohmann::ordered_json or_null(const std::string& text);

/// The number that an object has under a key; empty, or NaN, where it is null or absent.
std::optional<double> number_in(const nlohmann::ordered_json& object, const std::string& key);
double number_or_nan(const nlohmann::ordered_json& object, const std::string& key);

}  // namespace fretval
