#include "comparison/report/text/numbers.h"

#include <fmt/format.h>

#include <cmath>

#include "comparison/results/answer_text.h"

namespace fretval {
namespace {

/// A number of a comparison; null where there is none.
nlohmann::ordered_json compared(const StoredResult& result, const char* key, const char* number) {
  const auto& comparison = result.json.at("comparison");
  return comparison.contains(key) ? comparison[key].value(number, nlohmann::ordered_json()) : nlohmann::ordered_json();
}

}  // namespace

std::string number_text(const nlohmann::ordered_json& value, const char* format) {
  return value.is_number() && std::isfinite(value.get<double>())
             ? fmt::format(fmt::runtime(format), value.get<double>())
             : "–";
}

std::string counted(std::size_t n, const std::string& noun) {
  return fmt::format("{} {}{}", n, noun, n == 1 ? "" : "s");
}

std::string difference_text(const StoredResult& result, const char* key) {
  return number_text(compared(result, key, "difference"), "{:+.1e}");
}

std::string bar_text(const StoredResult& result, const char* key) {
  return number_text(compared(result, key, "error_bar"), "{:.0e}");
}

std::string difference_with_bar(const StoredResult& result, const char* key) {
  if (!result.json.at("comparison").contains(key)) return "–";
  return difference_text(result, key) + " ± " + bar_text(result, key);
}

double input_number(const StoredResult& result, const char* name, const char* section) {
  for (const auto& input : result.json.at("scene").value("inputs", nlohmann::ordered_json::array()))
    if (input.at("name") == name && (!section || input.at("section") == section) && input.at("value").is_number())
      return input["value"].get<double>();
  return std::nan("");
}

std::string input_word(const StoredResult& result, const char* name) {
  for (const auto& input : result.json.at("scene").value("inputs", nlohmann::ordered_json::array()))
    if (input.at("name") == name && input.at("value").is_string()) return input["value"].get<std::string>();
  return "";
}

std::string length_text(const StoredResult& result, const char* section, const char* key) {
  const double length = result.number(section, key);
  return std::isfinite(length) ? with_unit(length, 0, "m") : "–";
}

}  // namespace fretval
