#pragma once

#include <vector>

#include "comparison/model_error/map_table.h"

namespace fretval {

/// A made-up map of the phase: the shakedown radius is smaller than MDR has it by 10 % times 1 less the stick ratio, at
/// all phases; and of Poisson's ratio, where it is another 40 % times 1/2 - nu smaller.
inline std::vector<MapPoint> made_up_map(double bar = 0) {
  constexpr auto quantity = Quantity::stick_radius_shakedown;
  std::vector<MapPoint> points;
  const auto add = [&](MapKind kind, double ratio, double phase, double nu) {
    MapPoint point{name_of(kind), {}, "parabola", 0.5, nu < 0.5, false, {}};
    point.at.shakedown = ratio;
    point.at.phase = phase;
    point.at.poisson_ratio = nu;
    point.own = point.at;
    point.changes[quantity] = {-0.1 * (1 - ratio) - 0.4 * (0.5 - nu), bar};
    point.own_over_body[quantity] = 1;
    points.push_back(point);
  };
  for (const double ratio : {0.2, 0.4, 0.6, 0.8, 0.95}) {
    for (const double phase : {0.0, 60.0, 120.0}) add(MapKind::phase, ratio, phase, 0.5);
    for (const double nu : {0.0, 0.25, 0.5}) add(MapKind::poisson_ratio, ratio, 60, nu);
  }
  return points;
}

}  // namespace fretval
