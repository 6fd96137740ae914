#pragma once

#include <string>

namespace fretval {

/// A value in SI units for people: with the prefix that leaves one to three digits before the point of the value and at
/// most two before that of the bar, and with as many digits as the bar allows, or six: "0.79312 ± 0.00004 mm". bar:
/// absolute; 0 or less than nine decimals show: no bar is shown. unit: "m", "N", ….
std::string with_unit(double value, double bar, const std::string& unit);

/// The prefix that leaves one to three digits before the point.
struct UnitPrefix {
  const char* name;
  double factor;
};
UnitPrefix prefix_for(double value);

/// A value in SI units with that prefix, to so many digits: "0.503 mm" to three.
std::string with_prefix(double value, const std::string& unit, int digits = 3);

/// A volume with a unit, "1.5 mm³".
std::string volume_text(double cubic_metres);

/// The duration of a test to two digits: "40 min", "56 h", "3 years".
std::string time_text(double seconds);

}  // namespace fretval
