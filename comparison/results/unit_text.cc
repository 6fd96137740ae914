#include "comparison/results/unit_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace fretval {
namespace {

constexpr UnitPrefix of_nothing{"n", 1e-9};
constexpr std::array prefixes{
    UnitPrefix{"a", 1e-18}, UnitPrefix{"f", 1e-15}, UnitPrefix{"p", 1e-12}, of_nothing,           UnitPrefix{"µ", 1e-6},
    UnitPrefix{"m", 1e-3},  UnitPrefix{"", 1},      UnitPrefix{"k", 1e3},   UnitPrefix{"M", 1e6}, UnitPrefix{"G", 1e9}};

/// Decimals that show a bar with one digit, or a value with six.
int decimals_of(double value, double bar) {
  constexpr int six = 5, most = 9;
  const auto exponent = [](double x) { return static_cast<int>(std::floor(std::log10(std::abs(x)))); };
  constexpr double rounded_up = 0.95;  // 0.0097 becomes 0.01, one digit of which is a place to the left
  if (bar > 0 && std::isfinite(bar)) return std::clamp(-exponent(bar / rounded_up), 0, most);
  return value == 0 ? 0 : std::clamp(six - exponent(value), 0, most);
}

}  // namespace

UnitPrefix prefix_for(double value) {
  auto best = value == 0 ? of_nothing : prefixes.front();
  for (const auto& prefix : prefixes)
    if (std::abs(value) >= prefix.factor) best = prefix;
  return best;
}

std::string with_unit(double value, double bar, const std::string& unit) {
  // A bar of hundreds would have three digits.
  const auto& [name, factor] = prefix_for(std::isfinite(bar) ? std::max(std::abs(value), 10 * bar) : value);
  const double least = 1e-9 * factor;
  if (bar < least) bar = 0;
  if (value != 0 && std::abs(value) < least && bar < least) return fmt::format("0 {}{}", name, unit);  // roundoff
  const int decimals = decimals_of(value / factor, bar / factor);
  auto number = fmt::format("{:.{}f}", value / factor, decimals);
  if (number.find_first_of("123456789") == std::string::npos && number.front() == '-') number.erase(0, 1);
  if (bar <= 0 || !std::isfinite(bar)) return fmt::format("{} {}{}", number, name, unit);
  return fmt::format("{} ± {:.{}f} {}{}", number, bar / factor, decimals, name, unit);
}

std::string with_prefix(double value, const std::string& unit, int digits) {
  const auto& [name, factor] = prefix_for(value);
  return fmt::format("{:.{}g} {}{}", value / factor, digits, name, unit);
}

std::string volume_text(double cubic_metres) {
  return fmt::format("{:.6g} mm³", cubic_metres * 1e9);
}

std::string time_text(double seconds) {
  struct Unit {
    const char* name;
    double seconds;
  };
  constexpr double hour = 3600, day = 24 * hour, year = 365.25 * day, several = 2, thousand = 999.5;
  auto unit = Unit{"s", 1};
  for (const auto& larger : {Unit{"min", 60}, Unit{"h", hour}, Unit{"days", day}, Unit{"years", year}})
    if (seconds >= several * larger.seconds) unit = larger;
  const double value = seconds / unit.seconds;
  return value < thousand ? fmt::format("{:.3g} {}", value, unit.name) : fmt::format("{:.2g} {}", value, unit.name);
}

}  // namespace fretval
