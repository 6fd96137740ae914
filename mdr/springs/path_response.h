#pragma once

#include "mdr/motion/sampled_path.h"
#include "mdr/profiles/profile.h"
#include "mdr/rheology/prony_body.h"
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

/// Indentation that no relaxation of the body exceeds, as that of the same name in forced_response.h.
double deepest_indentation(const Profile& profile, const PronyBody& body, const SampledPath& path);

/// Steps the springs along a path, of which every row is the end of a step. A single pass begins relaxed at its first
/// row; of a path that repeats the departure from rest rises smoothly over the ramp, and periods go by until the
/// tractions repeat. Where a force is prescribed each step finds the displacement that balances it (force_balance.h).
/// Throws std::runtime_error when they do not after 2000 periods, GrossSlip with its instant between the steps,
/// std::invalid_argument for bad arguments.
PathCourse path_course(const Profile& profile, const PronyBody& body, double mu, const SampledPath& path,
                       const PathFineness& fineness = {});

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
SteppedPathForces path_forces(const Profile& profile, const PronyBody& body, double mu, const SampledPath& path,
                              PathFineness coarse = {});

}  // namespace fretval::mdr
