#pragma once

#include <vector>

#include "comparison/quantities/plane_edges.h"
#include "fem/full_contact/angular_grid.h"
#include "fem/full_contact/surface_history.h"

namespace fretval {

/// A zone of the contact around its centre, m and m².
struct PlaneZone {
  double area = 0, radius = 0;     ///< of the zone, and of the disc of that area
  double along = 0, across = 0;    ///< half of the extents along x and y
  double uncertainty = 0;          ///< of the radius, by reading it
  double edge_uncertainty = 0;     ///< of the edge where it is known worst, by reading it
  std::vector<double> edges = {};  ///< radius at each angle of the grid
};

/// The part of an answer that the contact on rings and angles adds to FeAnswer. For a single pass sticks_in_a_cycle
/// equals never_slipped; points of sticks_at_the_end may have slipped when they were touched.
struct SurfaceAnswer {
  PlaneZone never_slipped, sticks_in_a_cycle, sticks_at_the_end, contact;
  double transverse_force_max = 0;  ///< N, of |F_y|
  double torque_max = 0;            ///< N m
  fem::AngularGrid grid;
  fem::SurfaceHistory history;  ///< dimensionless
};

PlaneEdges edges_of(const SurfaceAnswer& surface);

}  // namespace fretval
