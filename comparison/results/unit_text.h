#pragma once

#include <string>

namespace fretval {

/// A value in SI units for people: with the prefix that leaves one to three digits before the point, of its bar at most
/// two, and as many digits as the bar allows, or six: "0.79312 ± 0.00004 mm". bar: absolute; 0, or less than nine
/// decimals show: none is known. unit: "m", "N", ….
std::string with_unit(double value, double bar, const std::string& unit);

/// The prefix that leaves one to three digits before the point.
struct UnitPrefix {
  const char* name;
  double factor;
};
UnitPrefix prefix_for(double value);

/// "1.5 mm³"
std::string volume_text(double cubic_metres);

/// "40 min", "56 h", "3 years": of a test, to two digits.
std::string time_text(double seconds);

}  // namespace fretval
