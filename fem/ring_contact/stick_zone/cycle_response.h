#pragma once

#include "fem/history/friction_history.h"
#include "fem/history/normal_history.h"
#include "fem/motion/relaxation.h"

namespace fretval::fem {

/// How far reading the rings may have put it off.
struct CycleUncertainty {
  double tangential_force_max, tangential_force_mean, friction_work;
  double cycle_work;  ///< of all that is lost
  double tangential_work;
};

/// What a locked motion asks of whoever drives it, in a cycle of the periodic state.
struct CycleResponse {
  double tangential_force_max;   ///< of |F_x|
  double tangential_force_mean;  ///< what slip has locked in
  double friction_work;          ///< lost to friction
  double bulk_work;              ///< lost inside the body; 0 without memory, and of a single pass, which does not tell
  double tangential_work;        ///< area of the tangential loop, `oint F_x du_x`; 0 of a single pass
  double sliding_force;          ///< mu times the largest normal force
  double sliding_work;           ///< what sliding under that force along the whole tangential path would cost
  CycleUncertainty uncertainty = {};
};

/// Area of the normal loop, `oint F_N dd`, or of a single pass the work that presses.
double normal_work(const Motion& motion, const NormalHistory& normal);

/// What is lost altogether is the area of both loops, `oint F_N dd + oint F_x du_x`. They are sums over the steps, of
/// spectral accuracy but for the kinks of the forces, with the exact rate of what is prescribed: `oint F du = -oint u
/// dF`. What friction takes is, in a body without memory, the tangential loop, whose force is read at the edges of its
/// zones; otherwise FrictionHistory::dissipated_energy. Extremes between the steps are those of RunningMinimum. Of
/// zones around the centre, of one cycle a period.
CycleResponse cycle_response(const RelaxationModel& relaxation, double friction_coefficient, const Motion& motion,
                             double normal_force_max, const NormalHistory& normal, const FrictionHistory& friction);

}  // namespace fretval::fem
