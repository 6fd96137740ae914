#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
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

/// Forces and works by one method that drive a locked motion through a cycle of the periodic state, or through a single
/// pass; SI units.
struct CycleReadings {
  Readings readings;     ///< of cycle_work the uncertainty alone: its value is friction_work + bulk_work
  double sliding_force;  ///< mu times the largest normal force
  double sliding_work;   ///< what sliding under that force along the whole tangential path would cost
  /// What was computed less what small steps give, as far as steps within which sliding ends put readings off; SI
  /// units.
  std::map<Quantity, double> off_by_steps = {};
  /// How far readings may be off by what lies between the steps: extremes, and jumps of a force; SI units.
  std::map<Quantity, double> between_steps = {};

  [[nodiscard]] double value(Quantity quantity) const;        ///< 0: there is none
  [[nodiscard]] double uncertainty(Quantity quantity) const;  ///< 0: there is none
};

/// Adds the readings of a cycle. Without memory all losses are those of friction, and the other works are not compared.
void add_cycle(const CycleReadings& cycle, Readings& readings);

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

/// Adds the value of each reading under the name of its quantity, null for none, in the order in which people ask for
/// them; `uncertainty` and `absent` hold, by quantity, the uncertainties and why there is no value.
void add_readings(const Readings& readings, nlohmann::ordered_json& json);

/// The reading of a quantity in the "fe" or "mdr" of a result.json, or of `fretval mdr --json`. Empty: it is not there.
std::optional<Reading> stored_reading(const nlohmann::ordered_json& method, Quantity quantity);

}  // namespace fretval
