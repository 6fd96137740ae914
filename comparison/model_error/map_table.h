#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "comparison/model_error/coordinates.h"
#include "comparison/quantities/quantity.h"

namespace fretval {

/// Coordinate of a map of MDR's error, beside the stick ratio: the phase with friction as a vector; Poisson's ratio of
/// a half-space, and the thickness of an incompressible layer, both with pressure and friction coupled; and the
/// thickness of such a layer under a normal force.
enum class MapKind { phase, poisson_ratio, layer, layer_by_force };
inline constexpr std::array all_maps{MapKind::phase, MapKind::poisson_ratio, MapKind::layer, MapKind::layer_by_force};
const char* name_of(MapKind kind);

/// Quantities that the maps have.
inline constexpr std::array mapped_quantities{Quantity::stick_radius_first_slip, Quantity::stick_radius_shakedown,
                                              Quantity::contact_radius_max,      Quantity::normal_force_max,
                                              Quantity::tangential_force_max,    Quantity::friction_work};

/// Relative change of a quantity from its value by MDR over the same body.
struct ModelChange {
  double value, bar;
};

/// A point of a map that was computed.
struct MapPoint {
  std::string map;  ///< name of its MapKind, or "elsewhere": a scene that no map contains, by which they are judged
  Coordinates at;
  std::string scene;  ///< in words
  double friction_coefficient = 0.5;
  bool coupled = false;
  bool memory = false;  ///< of the body
  std::map<Quantity, ModelChange> changes;
  /// The place of the scene by MDR over an incompressible half-space, and values by that over those of MDR over the
  /// body, by quantity.
  Coordinates own = {};
  std::map<Quantity, double> own_over_body = {};

  /// Relative error of MDR over an incompressible half-space, its value over the truth, less 1; empty: not known.
  [[nodiscard]] std::optional<ModelChange> own_off_by(Quantity quantity) const;
};

/// The committed points (model_error/map.csv), which docs/trust.md describes.
const std::vector<MapPoint>& map_points();

/// The points as CSV, a line for each: its place by MDR over its own body, and the change of each quantity with its
/// bar.
std::string csv_of(const std::vector<MapPoint>& points);

/// Whether two points are of one scene, to the digits of csv_of, whatever is known of them.
bool is_same_scene(MapPoint one, MapPoint other);

/// Throws InputError for text that is not of that form.
std::vector<MapPoint> points_of_csv(const std::string& text);

}  // namespace fretval
