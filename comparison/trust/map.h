#pragma once

#include <functional>
#include <string>
#include <vector>

#include "comparison/model_error/map_table.h"
#include "comparison/simulation/bodies/body_store.h"
#include "comparison/trust/map_scene.h"

namespace fretval {

/// A scene that is to be computed, and which map it belongs to.
struct PlannedPoint {
  std::string map, title;
  MapScene scene;
};

/// All points of all maps, and those elsewhere, by which the maps are judged: other stick ratios, indenters, bodies
/// with memory, coefficients of friction and ratios of the amplitudes. Those that share a body follow each other.
std::vector<PlannedPoint> planned_points();

/// Where MDR has a scene, without anything computed by finite elements.
MapPoint point_by_mdr(const PlannedPoint& planned, const Case& input);

/// Computes the change by a direction of friction that turns, and by coupling where the scene has it: what finite
/// elements find on the rings and angles over what they find on the same rings, in which errors of rings and steps
/// cancel. Bar: the sum of what the change is off by on half of the rings, of the steps and of the angles, which is the
/// error where that is of first order and more where it is of a higher one. Throws fem::SolverError.
MapPoint computed_point(const PlannedPoint& planned, BodyStore& bodies);

/// All points on all cores, in the order of the plan. done: after each, one call at a time.
std::vector<MapPoint> computed_map(const std::vector<PlannedPoint>& planned, BodyStore& bodies,
                                   const std::function<void(const MapPoint&, std::size_t n_done)>& done);

}  // namespace fretval
