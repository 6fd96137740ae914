#include "comparison/support/json.h"

#include <cmath>

namespace fretval {

using nlohmann::ordered_json;

ordered_json or_null(double value) {
  return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
}

ordered_json or_null(const std::optional<double>& value) {
  return value ? or_null(*value) : ordered_json(nullptr);
}

ordered_json or_null(const std::string& text) {
  return text.empty() ? ordered_json(nullptr) : ordered_json(text);
}

std::optional<double> number_in(const ordered_json& object, const std::string& key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_number() ? std::optional(found->get<double>()) : std::nullopt;
}

double number_or_nan(const ordered_json& object, const std::string& key) {
  return number_in(object, key).value_or(std::nan(""));
}

}  // namespace fretval
