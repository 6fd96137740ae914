#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "comparison/model_error/interpolated.h"
#include "comparison/model_error/map_table.h"

namespace fretval {

/// By how much MDR is off: its value over the truth, less 1.
struct ModelError {
  double value, uncertainty;
};

/// How good MDR over the body of a case is as a model: what friction of any direction, and where the body couples them
/// pressures, change.
struct ModelErrors {
  std::map<Quantity, ModelError> off_by;
  std::string outside = {};  ///< why the maps do not have the case; not empty: then there are no values

  /// The largest of both stick radii, whatever their uncertainty leaves open. Empty: neither is on the maps.
  [[nodiscard]] std::optional<double> good_to() const;
};

/// From the maps, at no cost. mdr: MDR's answer to the case.
///
/// The change by friction as a vector is that of the map over the phase; a half-space of another Poisson's ratio and a
/// layer add what their maps have more than on their sides of nu = 1/2 and a/H = 0. The uncertainty has the bars of the
/// points, what interpolation leaves open in either direction, and what the scenes elsewhere differ by: the largest
/// share of the change by which one of them lies outside its uncertainty otherwise.
ModelErrors model_errors_of(const Case& input, const MdrAnswer& mdr);

/// The stick ratio that a quantity is looked up by: a first-slip radius by its own, all others by the shakedown ratio.
std::optional<double> stick_ratio_for(const Coordinates& at, Quantity quantity);

/// The other coordinate of a map.
double value_on(MapKind kind, const Coordinates& at);

/// The change of a quantity on one of the maps. points: of the maps.
std::optional<Interpolated> change_on_map(const std::vector<MapPoint>& points, MapKind kind, Quantity quantity,
                                          double stick_ratio, double value);

/// By how much MDR over an incompressible half-space is off on one of the maps, where it has a stick ratio; value: of
/// the other coordinate, with the contact radius that it has.
std::optional<Interpolated> own_off_by_on_map(const std::vector<MapPoint>& points, MapKind kind, Quantity quantity,
                                              double stick_ratio, double value);

/// The same of a scene from all maps together; empty: outside. spread: see model_errors_of.
std::optional<Interpolated> change_at(const std::vector<MapPoint>& points, const Coordinates& at, Quantity quantity);

/// Which scenes elsewhere a case is judged by.
struct Elsewhere {
  bool coupled, memory;
};
double spread_elsewhere(const std::vector<MapPoint>& points, Quantity quantity, const Elsewhere& where);

}  // namespace fretval
