#pragma once

#include <map>
#include <optional>
#include <string>

#include "comparison/quantities/quantity.h"

namespace fretval {

/// What one method says of a quantity, SI units.
struct Reading {
  std::optional<double> value;
  /// By which reading or stepping it may be off in this method, whatever its resolution; empty: nothing of the kind.
  std::optional<double> uncertainty = {};
  std::string why_absent = {};  ///< without a value, for people
  /// Whether it is held to the other method's. If not, it is only told: another quantity of the case says the same, or
  /// it is prescribed. Without a value what is compared counts as 0: nothing sticks.
  bool is_compared = true;
};
using Readings = std::map<Quantity, Reading>;

/// In the units of comparison, in which error bars are added up: radii over the unworn contact radius (0: nothing
/// sticks), forces and energies over those of sliding or as logarithms, so that differences are relative.
using Quantities = std::map<Quantity, double>;

/// Finite elements' less MDR's over the scale of the quantity (scale_of, of MDR's value). Empty: only one of both has a
/// value, or neither.
std::optional<double> difference_of(Quantity quantity, const Reading& fe, const Reading& mdr, const Scales& scales);

/// What is not a difference where only one has a value: all of that over the scale.
double only_one_of(Quantity quantity, const Reading& fe, const Reading& mdr, const Scales& scales);

/// What the readings that are compared may be off by, over their scales.
Quantities uncertainties_of(const Readings& readings, const Scales& scales);

/// Absolute differences of what both have, but for what comes along.
Quantities errors_of(const Quantities& values, const Quantities& reference);

/// The largest one; NaN for none.
double largest_of(const Quantities& errors);

}  // namespace fretval
