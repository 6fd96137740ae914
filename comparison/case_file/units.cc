#include "comparison/case_file/units.h"

#include <charconv>
#include <cmath>
#include <vector>

#include "comparison/support/constants.h"
#include "mdr/support/trimmed.h"

namespace fretval {
namespace {

/// A value in it is value * times / over + zero in the base unit. Over, not times 1e-6: 20 um is the number 2e-5.
struct Unit {
  const char* name;
  double times = 1, over = 1, zero = 0;
  bool listed = true;
};

/// The base unit first. Micro is the sign of its own or the Greek letter.
std::vector<Unit> units_of(Dimension dimension) {
  switch (dimension) {
    case Dimension::length:
      return {{"m"},          {"cm", 1, 1e2},      {"mm", 1, 1e3},
              {"um", 1, 1e6}, {"\u00b5m", 1, 1e6}, {"\u03bcm", 1, 1e6, 0, false},
              {"nm", 1, 1e9}};
    case Dimension::frequency:
      return {{"Hz"}, {"mHz", 1, 1e3}, {"kHz", 1e3}, {"rad/s", 1, 2 * pi}};
    case Dimension::pressure:
      return {{"Pa"}, {"kPa", 1e3}, {"MPa", 1e6}, {"GPa", 1e9}, {"N/mm^2", 1e6}, {"N/mm\u00b2", 1e6, 1, 0, false}};
    case Dimension::time:
      return {{"s"},
              {"sec", 1, 1, 0, false},
              {"ms", 1, 1e3},
              {"us", 1, 1e6},
              {"\u00b5s", 1, 1e6},
              {"\u03bcs", 1, 1e6, 0, false},
              {"min", 60},
              {"h", 3600}};
    case Dimension::angle:
      return {{"deg"}, {"\u00b0"}, {"rad", 180, pi}};
    case Dimension::viscosity:
      return {{"Pa s"}, {"kPa s", 1e3}, {"MPa s", 1e6}};
    case Dimension::force:
      return {{"N"},
              {"kN", 1e3},
              {"MN", 1e6},
              {"mN", 1, 1e3},
              {"uN", 1, 1e6},
              {"\u00b5N", 1, 1e6},
              {"\u03bcN", 1, 1e6, 0, false},
              {"nN", 1, 1e9}};
    case Dimension::temperature:
      return {{"degC"}, {"\u00b0C"}, {"K", 1, 1, -273.15}};
    case Dimension::difference:
      return {{"K"}, {"degC"}, {"\u00b0C"}};
    case Dimension::wear_rate:
      return {{"1/Pa"},
              {"1/kPa", 1, 1e3},
              {"1/MPa", 1, 1e6},
              {"1/GPa", 1, 1e9},
              {"mm^3/(N m)", 1, 1e9},
              {"mm\u00b3/(N m)", 1, 1e9, 0, false},
              {"mm^3/Nm", 1, 1e9, 0, false},
              {"mm\u00b3/Nm", 1, 1e9, 0, false}};
    case Dimension::number:
    case Dimension::varying:
      break;
  }
  return {};
}

}  // namespace

std::optional<Measure> read_measure(const std::string& text, Dimension dimension) {
  double value = 0;
  const bool has_plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
  const char *const first = text.data() + (has_plus ? 1 : 0), *const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(first, last, value);
  if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
  const auto name = trimmed(std::string(end, last));
  if (name.empty()) return Measure{value, false};
  for (const auto& unit : units_of(dimension))
    if (name == unit.name) return Measure{value * unit.times / unit.over + unit.zero, true};
  return std::nullopt;
}

std::string base_unit(Dimension dimension) {
  if (dimension == Dimension::varying) return "SI";
  const auto units = units_of(dimension);
  return units.empty() ? "" : units.front().name;
}

std::string valid_units(Dimension dimension) {
  if (dimension == Dimension::number) return "a pure number, without a unit";
  if (dimension == Dimension::varying) return "in SI, without a unit: which one depends on another entry";
  return "in " + base_unit(dimension) + ", " + other_units(dimension) + "; in " + base_unit(dimension) +
         " without a unit";
}

std::string other_units(Dimension dimension) {
  std::string list;
  for (const auto& unit : units_of(dimension))
    if (unit.listed && unit.name != base_unit(dimension)) list += (list.empty() ? "" : ", ") + std::string(unit.name);
  return list;
}

}  // namespace fretval
