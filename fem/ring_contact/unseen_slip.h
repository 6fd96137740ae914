#pragma once

#include <Eigen/Dense>

#include "fem/ring_contact/punch_series.h"

namespace fretval::fem {

/// Energy of friction in an oscillation in which no ring slips, because less than a ring does at the edge, or the
/// outermost one alone, which shows little of it; 0 where more rings slip, which show it. Dimensionless.
///
/// The limit l = mu p of the two outermost rings in contact is continued outwards to the edge, where l = 0, and so is
/// l - t of the two outermost rings that stick, t: the traction; both as depths of the PunchSeries. If t is more than l
/// at the edge, what lies between slips to and fro by 4 (t - l) in an oscillation against l, which is the energy
/// 4 int l (t - l) dF = 2/3 l_s t_e dF, l_s: where slip begins, t_e: at the edge. The largest one of the steps counts.
/// 0 where t vanishes at the edge as l does, as in a motion in phase.
///
/// depths, limit_depths: of the traction and of mu p, a column a step.
double unseen_slip_energy(const PunchSeries& series, const Eigen::MatrixXd& depths,
                          const Eigen::MatrixXd& limit_depths);

}  // namespace fretval::fem
