#include "fem/history/cycle_jump.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fretval::fem {
namespace {

constexpr double worthwhile = 3;   // periods
constexpr double share = 0.7;      // of the jump that a single rate of decay would ask for
constexpr double lengthening = 4;  // of one jump over the last one
constexpr double roundoff = 1e-15;

double product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return a.cwiseProduct(b).sum();
}

/// A column for the displacements, with the indenter last, and one for each memory.
Eigen::MatrixXd packed(const RingState& state, double indenter) {
  const Eigen::Index n = state.displacement.size();
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(n + 1, state.memory.cols() + 1);
  all.col(0).head(n) = state.displacement;
  all(n, 0) = indenter;
  all.topRightCorner(n, state.memory.cols()) = state.memory;
  return all;
}

}  // namespace

double longest_creep_time(const RelaxationModel& relaxation) {
  double longest = 0, viscosity = relaxation.viscosity;
  for (std::size_t i = 0; i < relaxation.times.size(); ++i) {
    longest = std::max(longest, relaxation.times[i]);
    viscosity += relaxation.moduli[i] * relaxation.times[i];
  }
  return longest + viscosity / relaxation.relaxed;
}

double change_to_come(double change, double periods) {
  const double sum = periods <= 0 ? 1 : std::max(1.0, 1 / std::expm1(1 / periods));
  return sum * std::max(change, roundoff);
}

bool CycleJump::advance(RingState& state, double& indenter) {
  if (slowest_ < worthwhile) return false;
  const Eigen::Index n = state.displacement.size();
  Eigen::MatrixXd end = packed(state, indenter);
  bool moved = false;
  if (n_periods_ > 0) {
    Eigen::MatrixXd drift = end - begin_;
    if (n_periods_ > 1 && n_periods_ % 2 == 0) {
      const Eigen::MatrixXd way = begin_ - begin_before_;
      const double rate = -product(way, drift - drift_before_) / way.squaredNorm();
      longest_ = std::min(lengthening * longest_, slowest_);
      const double length = rate > 1 / longest_ ? 1 / rate - 1 : longest_;
      if (length * share >= 1) {
        longest_ = length;
        end += share * length * drift;
        state.displacement = end.col(0).head(n);
        state.memory = end.topRightCorner(n, end.cols() - 1);
        indenter = end(n, 0);
        moved = true;
      }
    }
    begin_before_ = std::exchange(begin_, end);
    drift_before_ = std::move(drift);
  } else {
    begin_ = std::move(end);
  }
  ++n_periods_;
  return moved;
}

}  // namespace fretval::fem
