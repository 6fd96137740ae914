#pragma once

#include "fem/history/friction_history.h"
#include "fem/history/normal_history.h"
#include "fem/motion/relaxation.h"

namespace fretval::fem {

/// Uncertainties of a CycleResponse.
struct CycleUncertainty {
  double tangential_force_max, tangential_force_mean, friction_work;
  double cycle_work;  ///< of friction_work + bulk_work
  double tangential_work;
};

/// By how much steps within which sliding ends put a CycleResponse off, see force_off_by_sliding_ends: what was
/// computed less what small steps give.
struct CycleOffset {
  double tangential_force_max = 0, tangential_force_mean = 0;
  double work = 0;  ///< of tangential_work, friction_work and what is lost altogether
};

/// How far what lies between the samples may put a CycleResponse off: the largest |F_x| there and, in a body with
/// memory, jumps of the forces.
struct CycleBetweenSteps {
  double tangential_force_max = 0, tangential_force_mean = 0;
  double tangential_work = 0;
  double cycle_work = 0;  ///< of both loops
};

/// Forces and works that drive a locked motion through a cycle of the periodic state. Dimensionless.
struct CycleResponse {
  double tangential_force_max;   ///< of |F_x|
  double tangential_force_mean;  ///< what slip has locked in
  double friction_work;          ///< lost to friction
  double bulk_work;              ///< lost inside the body; 0 without memory and for a single pass, where it is unknown
  double tangential_work;        ///< area of the tangential loop, `oint F_x du_x`; 0 for a single pass
  double sliding_force;          ///< mu times the largest normal force
  double sliding_work;           ///< what sliding under that force along the whole tangential path would cost
  CycleUncertainty uncertainty = {};  ///< from the reading of the rings
  CycleOffset off_by_steps = {};
  CycleBetweenSteps between_steps = {};
};

/// Area of the normal loop, `oint F_N dd`; for a single pass the work of the normal force.
double normal_work(const Motion& motion, const NormalHistory& normal);

/// What is lost altogether is the area of both loops, `oint F_N dd + oint F_x du_x`. The areas are sums over the steps,
/// of spectral accuracy but for the kinks of the forces, with the exact rate of what is prescribed: under a force `oint
/// F du = -oint u dF`. In a body without memory the loss by friction is the tangential loop, whose force is read at the
/// edges of its zones; otherwise it is FrictionHistory::dissipated_energy. Extremes between the steps are those of
/// RunningMinimum. For contacts whose zones lie around the centre, and motions with one cycle in a period.
CycleResponse cycle_response(const RelaxationModel& relaxation, double friction_coefficient, const Motion& motion,
                             double normal_force_max, const NormalHistory& normal, const FrictionHistory& friction);

}  // namespace fretval::fem
