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

}  // namespace fretval
