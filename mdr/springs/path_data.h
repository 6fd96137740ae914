#pragma once

#include "mdr/springs/spring_bed.h"
#include "mdr/springs/spring_history.h"

namespace fretval::mdr {

/// What the transient spring foundation says about a path: over its pass, or over the last period once it repeats.
/// Times and tangential displacements are those of the path. A pass is one period, and has no shakedown: those depths
/// are 0.
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
  int subdivisions = 1;          ///< of each of these steps
};

/// The numbers of a course. Depths of stick zones are those of SpringHistory, settled.
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

/// Extrapolated from n and 2 n springs, steps and periods of the ramp, each of second order; error: the whole
/// difference. course: the finer one. Under forces the ramp lasts ten creep times at least.
struct SteppedPathForces {
  PathForces forces, error;
  PathCourse course;
};

}  // namespace fretval::mdr
