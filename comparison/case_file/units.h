#pragma once

#include <optional>
#include <string>

namespace fretval {

/// What a number of a case file measures, and so which units it may have.
enum class Dimension {
  number,       ///< none
  length,       ///< m
  frequency,    ///< Hz
  pressure,     ///< Pa
  time,         ///< s
  angle,        ///< deg
  viscosity,    ///< Pa s
  force,        ///< N
  temperature,  ///< degrees Celsius
  difference,   ///< of temperatures, K
  wear_rate,    ///< 1/Pa: worn volume per force and path
  varying       ///< depends on another entry: SI, without a unit
};

/// A number as it stands in a case file, "5 mm": its value in the base unit of the dimension (see above), which also
/// holds where no unit is written. Empty: no finite number, or a unit that does not measure this.
struct Measure {
  double value;
  bool has_unit;
};
std::optional<Measure> read_measure(const std::string& text, Dimension dimension);

/// The unit of a number that is written without one: "m", "1/Pa", …; empty for numbers, "SI" where it varies.
std::string base_unit(Dimension dimension);

/// The other units of a dimension, "cm, mm, um, µm, nm".
std::string other_units(Dimension dimension);

/// "in m, cm, mm, um, µm, nm; m without a unit", for messages; "a pure number, without a unit".
std::string valid_units(Dimension dimension);

}  // namespace fretval
