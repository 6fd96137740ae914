#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "comparison/model_error/interpolated.h"
#include "comparison/model_error/map_table.h"

namespace fretval {

/// How good MDR over the body of a case is as a model: the changes by friction of any direction and, where the body
/// couples pressure and friction, by the coupling.
struct ModelErrors {
  std::map<Quantity, Interpolated> off_by;  ///< relative errors of MDR: its value over the truth, less 1
  std::string outside = {};                 ///< why the maps do not have the case; not empty: then there are no values

  /// The larger error of the two stick radii, with its uncertainty included. Empty: neither radius is on the maps.
  [[nodiscard]] std::optional<double> good_to() const;
};

/// The errors of MDR for a case, read from the maps at no cost. mdr: MDR's answer to the case.
///
/// The change by friction as a vector is that of the map over the phase; a half-space of another Poisson's ratio and a
/// layer add the difference of their maps from the values at nu = 1/2 and a/H = 0. The uncertainty consists of the bars
/// of the points, of the errors of interpolation in either direction, and of the spread of the scenes elsewhere: the
/// largest share of the change by which one of them would lie outside of its uncertainty without it.
ModelErrors model_errors_of(const Case& input, const MdrAnswer& mdr);

/// The stick ratio that a quantity is looked up by: a first-slip radius by its own, all others by the shakedown ratio.
std::optional<double> stick_ratio_for(const Coordinates& at, Quantity quantity);

/// The coordinate of a map beside the stick ratio, at a place: phase in degrees, Poisson's ratio or a/H.
double value_on(MapKind kind, const Coordinates& at);

/// The change of a quantity on one of the maps, interpolated between its points. value: the coordinate beside the stick
/// ratio.
std::optional<Interpolated> change_on_map(const std::vector<MapPoint>& points, MapKind kind, Quantity quantity,
                                          double stick_ratio, double value);

/// The error of MDR over an incompressible half-space on one of the maps, at the stick ratio that this model finds.
/// value: the coordinate beside the stick ratio, with the contact radius of this model.
std::optional<Interpolated> own_off_by_on_map(const std::vector<MapPoint>& points, MapKind kind, Quantity quantity,
                                              double stick_ratio, double value);

/// The change of a quantity at a place, from all maps together. Empty: the place lies outside of the maps.
std::optional<Interpolated> change_at(const std::vector<MapPoint>& points, const Coordinates& at, Quantity quantity);

/// Kind of the scenes elsewhere by which a case is judged.
struct Elsewhere {
  bool coupled, memory;
};
double spread_elsewhere(const std::vector<MapPoint>& points, Quantity quantity, const Elsewhere& where);

}  // namespace fretval
