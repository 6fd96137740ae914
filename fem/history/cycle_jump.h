#pragma once

#include <Eigen/Dense>

#include "fem/motion/relaxation.h"

namespace fretval::fem {

/// Bound on the longest time in which an unloaded ring creeps back, in the unit of the model's times:
///   max tau_i + (sum G_i tau_i + viscosity) / relaxed
/// Exact for one branch, tau (1 + G_1/relaxed), and for a dashpot alone. It is what a response takes to become
/// periodic, and much longer than the relaxation times where the body is soft at rest and stiff in motion.
double longest_creep_time(const RelaxationModel& relaxation);

/// What is still to come of a relative change in one period if it dies out like exp(-k/n) over n periods:
///   change sum_{k >= 1} exp(-k/n) = change/(exp(1/n) - 1), at least the change
/// Judged by it a history that creeps for a thousand periods does not count as periodic because a single period changes
/// it little. A change below roundoff counts as roundoff: no period can tell whether a body that creeps for 1e12
/// periods has settled.
double change_to_come(double change, double periods);

/// Shortens a history that creeps for many periods to its periodic state: after every second period the rings are
/// moved on along their drift, as if they had gone on with it for a number of periods. The periodic state does not
/// depend on the way to it, and a history is only taken for periodic by what plain periods do to it. Rings that stick
/// have no drift, and stay.
///
/// With x_k the state at the start of period k and d_k its drift in it, the length of the jump is 1/lambda - 1 periods,
/// lambda = -<x_k - x_(k-1), d_k - d_(k-1)> / |x_k - x_(k-1)|^2, of which a share is taken, no longer than the slowest
/// creep, and no more than four times the last one. Source: Barzilai and Borwein 1988, step length 1, for the fixed
/// point of a period.
class CycleJump {
 public:
  /// slowest: longest creep time in periods. If it is too short for jumps to be needed, nothing is ever moved.
  explicit CycleJump(double slowest) : slowest_(slowest) {}

  /// To be called after each period. indenter: displacement of the indenter, which is moved along with the rings.
  /// Returns whether the state was moved.
  bool advance(RingState& state, double& indenter);

 private:
  double slowest_, longest_ = 2;
  int n_periods_ = 0;
  Eigen::MatrixXd begin_, begin_before_, drift_before_;  // displacement and memories, one column each
};

}  // namespace fretval::fem
