#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "comparison/model_error/coordinates.h"
#include "comparison/quantities/quantity.h"

namespace fretval {

/// What the maps of MDR's error are over, beside the stick ratio: the phase with friction as a vector; Poisson's ratio
/// of a half-space, and how thick an incompressible layer is, with pressure and friction coupled; and the latter under
/// a normal force.
enum class MapKind { phase, poisson_ratio, layer, layer_by_force };
inline constexpr std::array all_maps{MapKind::phase, MapKind::poisson_ratio, MapKind::layer, MapKind::layer_by_force};
const char* name_of(MapKind kind);

/// Quantities that the maps have.
inline constexpr std::array mapped_quantities{Quantity::stick_radius_first_slip, Quantity::stick_radius_shakedown,
                                              Quantity::contact_radius_max,      Quantity::normal_force_max,
                                              Quantity::tangential_force_max,    Quantity::friction_work};

/// By how much something is larger than MDR has it over the same body, over MDR's value.
struct ModelChange {
  double value, bar;
};

/// A point that was computed.
struct MapPoint {
  std::string map;  ///< name of its MapKind, or "elsewhere": a scene that no map contains, by which they are judged
  Coordinates at;
  std::string scene;  ///< in words
  double friction_coefficient = 0.5;
  bool coupled = false;
  bool memory = false;  ///< of the body
  std::map<Quantity, ModelChange> changes;
  /// Where MDR over an incompressible half-space has it, and its value over that of MDR over the body, by quantity.
  Coordinates own = {};
  std::map<Quantity, double> own_over_body = {};

  /// By how much MDR over an incompressible half-space is off, its value over the truth, less 1; empty: not there.
  [[nodiscard]] std::optional<ModelChange> own_off_by(Quantity quantity) const;
};

/// The committed points (model_error/map.csv), which docs/trust.md describes.
const std::vector<MapPoint>& map_points();

/// CSV, a line a point: where it is by MDR over its own body, and of each quantity the change and its bar.
std::string csv_of(const std::vector<MapPoint>& points);

/// Throws InputError for text that is not of that form.
std::vector<MapPoint> points_of_csv(const std::string& text);

}  // namespace fretval
