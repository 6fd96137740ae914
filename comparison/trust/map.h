#pragma once

#include <functional>
#include <string>
#include <vector>

#include "comparison/model_error/map_table.h"
#include "comparison/simulation/bodies/body_store.h"
#include "comparison/trust/map_scene.h"

namespace fretval {

/// A scene that is to be computed, and the map to which it belongs.
struct PlannedPoint {
  std::string map, title;
  MapScene scene;
};

/// All points of all maps, and those elsewhere, by which the maps are judged: other stick ratios, indenters, bodies
/// with memory, coefficients of friction and ratios of the amplitudes. Points that share a body follow each other.
std::vector<PlannedPoint> planned_points();

/// The point of a scene with its coordinates by MDR, before anything is computed by finite elements.
MapPoint point_by_mdr(const PlannedPoint& planned, const Case& input);

/// Computes the change by friction whose direction turns, and by coupling where the scene has it: values by finite
/// elements on rings and angles over those on the same rings, in which errors of rings and steps cancel. Its bar adds
/// what rings, steps and angles leave, by the orders that coarser computations show (error_budget), and what has not
/// settled. Where a bar is wider than a tenth of its effect, what adds most to it is refined, up to four
/// times. fineness: rings and steps over the usual ones; with less than 1 nothing is refined. Throws fem::SolverError.
MapPoint computed_point(const PlannedPoint& planned, BodyStore& bodies, double fineness = 1);

/// All points on all cores, in the order of the plan. known: points that are not computed again, as far as they are of
/// planned scenes. done: called after each point that was computed, one call at a time, with all points, of which those
/// that are still missing have no changes. A point that fails is told to the log, and has no changes.
std::vector<MapPoint> computed_map(
    const std::vector<PlannedPoint>& planned, const std::vector<MapPoint>& known, BodyStore& bodies,
    const std::function<void(const std::vector<MapPoint>& points, std::size_t computed)>& done);

}  // namespace fretval
