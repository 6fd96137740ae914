#pragma once

#include <Eigen/Core>

#include "mdr/rheology/prony_body.h"
#include "mdr/springs/spring_step.h"

namespace fretval::mdr {

/// Periods in which springs creep back by 1/e while nothing touches them, at most: (max tau_i + sum G_i tau_i/G0)/T.
/// A dashpot is not counted.
double creep_periods(const PronyBody& body, double period);

/// Brings springs of a body that creeps for many periods to the state that repeats. Where x_k is the state of a spring
/// at the start of period k,
/// and d(x) = F(x) - x its drift in a period, fast modes die out in a few periods, and the drift that is left falls by
/// nearly the same share lambda in each: the state that repeats lies d/lambda ahead. So after every third period each
/// spring goes on along its drift by 1/lambda - 1 periods, with
///
///   lambda = -sum y (d(x + y) - d(x)) / sum y^2
///
/// over its tips and memories (the secant method for d = 0, in the mean over the components of a spring); y: the last
/// jump, before the first one the way of a period; bounded by the slowest creep. The state that repeats does not depend
/// on the way to it, and plain periods alone tell whether it is reached. Springs that do not drift stay where they are.
class CreepJump {
 public:
  /// mu: weighs normal loads against tangential ones, see change_of_tractions(). Bodies that creep for less than some
  /// hundred periods are left alone: plain periods lead there.
  CreepJump(const PronyBody& body, double mu, double period);

  /// To be called after each period of the motion that repeats. Moves the state, the indenter included where forces
  /// move it. Throws std::runtime_error for bodies that creep for more than 1e7 periods.
  void after_period(SpringState& state);

  /// Largest change of a traction over the largest traction, by which the last jump expected the state to be away from
  /// that which repeats. 0: the body needs no jumps.
  [[nodiscard]] double to_come() const { return to_come_; }

 private:
  /// lambda of the coming jump of each row (spring) after a drift, from the last jump or from the way of a period,
  /// whichever makes the shorter jump, as slip that a jump adds without cause stays locked in. Roundoff hides how
  /// drifts fall in a period long before it hides how they fell over a jump, which alone tells then.
  Eigen::ArrayXd rates(const Eigen::ArrayXXd& drift);

  bool needed_;
  double mu_, slowest_;  // slowest: periods
  double to_come_;
  int n_periods_ = 0;
  // springs x (tips, memories, loads), and the indenter as the last row
  Eigen::ArrayXXd begin_, drift_, drift_of_jump_, jump_;
  Eigen::ArrayXd lambda_;  // by row, over the last jump if that was longer than the way of a period
};

}  // namespace fretval::mdr
