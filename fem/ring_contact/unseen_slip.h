#pragma once

#include <Eigen/Dense>

#include "fem/ring_contact/punch_series.h"

namespace fretval::fem {

/// Energy of friction in an oscillation of a contact that keeps its rings and of which none slips, because less than a
/// ring does at its edge; 0 where a ring slips, touches or lifts, which shows what slips. Dimensionless.
///
/// From the two outermost rings in contact the limit l = mu p and the traction t, as depths of the PunchSeries, are
/// continued outwards to where l = 0. If t is more than l there, what lies between slips to and fro by 4 (t - l) in an
/// oscillation against l, which is the energy 4 int l (t - l) dF = 2/3 l_s t_e dF, l_s: where slip begins, t_e: at the
/// edge. The largest one of the steps counts. 0 where t vanishes at the edge as l does, as in a motion in phase.
///
/// depths, limit_depths: of the traction and of mu p, a column a step.
double unseen_slip_energy(const PunchSeries& series, const Eigen::MatrixXd& depths,
                          const Eigen::MatrixXd& limit_depths);

}  // namespace fretval::fem
