#include "comparison/json_parts.h"

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

ordered_json focus_json(const Focus& focus) {
  return {{"inner", focus.inner}, {"outer", focus.outer}, {"ring", focus.ring}};
}

ordered_json focus_json(const std::map<std::string, Focus>& focus) {
  auto json = ordered_json::object();
  for (const auto& [quantity, one] : focus) json[quantity] = focus_json(one);
  return json;
}

}  // namespace fretval
