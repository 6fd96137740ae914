#pragma once

#include "mdr/springs/spring_bed.h"
#include "mdr/springs/spring_history.h"

namespace fretval::mdr {

/// What the transient spring foundation says about a path: over its pass, or over the last period once it repeats.
/// Times and tangential displacements are those of the path. A pass counts as one period; it has no shakedown, and its
/// depth of shakedown and its settling_depth are 0.
struct PathCourse {
  SpringBed bed;
  SpringHistory history;
};

/// How finely springs are stepped along a path.
struct PathFineness {
  Eigen::Index n_springs = 200;
  int steps_per_duration = 180;  ///< at least; each piece has a whole number of equal steps
  int n_ramp_periods = 10;       ///< of a path that repeats
  double periodicity = 1e-8;     ///< see periodicity_of
  int subdivisions = 1;          ///< further division of each of these steps
};

/// Largest and mean values, works and depths of stick zones of a course. The depth of shakedown is
/// SpringHistory::settling_depth.
struct PathForces {
  double normal_force_max, normal_force_min;  ///< N
  double axis_pressure_max;                   ///< Pa; of springs, also under a sharp tip
  double tangential_force_max;                ///< N, of |F_x|
  double tangential_force_mean;               ///< N, over time
  double friction_work, bulk_work;            ///< J
  double tangential_work;                     ///< J, int F_x du_x
  double largest_indentation;                 ///< m
  double tangential_amplitude;                ///< m, half of what lies between the extremes of u_x
  double tangential_way;                      ///< m, length of the tangential path of the indenter
  double first_slip, shakedown;               ///< m, g(c); of a pass shakedown is 0
};

/// Numbers extrapolated from n and 2 n springs, steps and periods of the ramp, each of second order; error: the whole
/// difference of the two computations. course: that of the finer one. Under forces the ramp lasts at least ten creep
/// times.
struct SteppedPathForces {
  PathForces forces, error;
  PathCourse course;
};

}  // namespace fretval::mdr
