#pragma once

#include <map>
#include <optional>
#include <string>

#include "comparison/quantities/quantity.h"

namespace fretval {

/// Value of a quantity by one method, SI units.
struct Reading {
  std::optional<double> value;
  /// Uncertainty from reading or stepping in this method, which a finer resolution does not reduce; empty: none.
  std::optional<double> uncertainty = {};
  std::string why_absent = {};  ///< without a value, for people
  /// Whether it is compared with the other method. If not, it is only told: another quantity of the case says the same,
  /// or it is prescribed. A reading that is compared but has no value counts as 0: nothing sticks.
  bool is_compared = true;
};
using Readings = std::map<Quantity, Reading>;

/// Values in the units of comparison, in which error bars are added up: radii over the unworn contact radius (0:
/// nothing sticks), forces and energies over those of sliding, or as logarithms where differences are relative.
using Quantities = std::map<Quantity, double>;

/// Value by finite elements less MDR's, over the scale of the quantity (scale_of with MDR's value). Empty: not both of
/// them have a value.
std::optional<double> difference_of(Quantity quantity, const Reading& fe, const Reading& mdr, const Scales& scales);

/// The value of the only method that has one, over the scale; takes the place of a difference then.
double only_one_of(Quantity quantity, const Reading& fe, const Reading& mdr, const Scales& scales);

/// Uncertainties of the readings that are compared, over their scales.
Quantities uncertainties_of(const Readings& readings, const Scales& scales);

/// Absolute differences of the quantities that both have and that are not only told.
Quantities errors_of(const Quantities& values, const Quantities& reference);

/// The largest of the errors; NaN if there are none.
double largest_of(const Quantities& errors);

}  // namespace fretval
