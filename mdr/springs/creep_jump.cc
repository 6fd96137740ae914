#include "mdr/springs/creep_jump.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

#include "mdr/springs/repetition.h"

namespace fretval::mdr {
namespace {

constexpr double long_creep = 100;           // of creep; plain periods go on for 20 times as long
constexpr double longest_creep = 1e7;        // of creep: below, what is still to come of loads shows in a period
constexpr int periods_of_a_jump = 3;         // fast modes die out in them, and the last two tell the slow one
constexpr double roundoff_of_drift = 1e-14;  // of a drift, over what drifts
constexpr Eigen::Index n_loads = 2;

// The state as an array: a row for each spring with its tips, memories and loads, and a last row for the indenter.
Eigen::ArrayXXd packed(const SpringState& state) {
  const Eigen::Index n = state.normal_depth.size(), n_memories = state.normal_memory.cols();
  Eigen::ArrayXXd all = Eigen::ArrayXXd::Zero(n + 1, 2 + 2 * n_memories + n_loads);
  all.col(0).head(n) = state.normal_depth;
  all.col(1).head(n) = state.tangential_shift;
  all.block(0, 2, n, n_memories) = state.normal_memory;
  all.block(0, 2 + n_memories, n, n_memories) = state.tangential_memory;
  all.col(all.cols() - 2).head(n) = state.normal_load;
  all.col(all.cols() - 1).head(n) = state.tangential_load;
  all(n, 0) = state.indenter.indentation;
  all(n, 1) = state.indenter.tangential;
  return all;
}

// Product of two arrays for each spring, over tips and memories.
Eigen::ArrayXd products(const Eigen::ArrayXXd& a, const Eigen::ArrayXXd& b) {
  return (a * b).leftCols(a.cols() - n_loads).rowwise().sum();
}

Eigen::ArrayXd squares(const Eigen::ArrayXXd& a) {
  return products(a, a);
}

void move_by(const Eigen::ArrayXXd& way, SpringState& state) {
  const Eigen::Index n = state.normal_depth.size(), n_memories = state.normal_memory.cols();
  state.normal_depth += way.col(0).head(n);
  state.tangential_shift += way.col(1).head(n);
  state.normal_memory += way.block(0, 2, n, n_memories);
  state.tangential_memory += way.block(0, 2 + n_memories, n, n_memories);
  // Springs that touch keep touching until the next step tells.
  const Eigen::ArrayXd load = state.normal_load + way.col(way.cols() - 2).head(n);
  state.normal_load = (load > 0).select(load, state.normal_load);
  state.tangential_load += way.col(way.cols() - 1).head(n);
  for (IndenterState* indenter : {&state.indenter, &state.indenter_before}) {
    indenter->indentation += way(n, 0);
    indenter->tangential += way(n, 1);
  }
}

}  // namespace

double creep_periods(const PronyBody& body, double period) {
  double longest = 0, creep = 0;
  for (std::size_t i = 0; i < body.branch_times.size(); ++i) {
    longest = std::max(longest, body.branch_times[i]);
    creep += body.branch_moduli[i] / body.relaxed_modulus * body.branch_times[i];
  }
  return (longest + creep) / period;
}

CreepJump::CreepJump(const PronyBody& body, double mu, double period)
    : needed_(creep_periods(body, period) > long_creep),
      mu_(mu),
      slowest_(creep_periods(body, period)),
      to_come_(needed_ ? std::numeric_limits<double>::infinity() : 0) {}

Eigen::ArrayXd CreepJump::rates(const Eigen::ArrayXXd& drift) {
  const auto size = [](const Eigen::ArrayXXd& way) -> Eigen::ArrayXd { return squares(way).sqrt(); };
  const auto fall_over = [](const Eigen::ArrayXXd& way, const Eigen::ArrayXXd& change) -> Eigen::ArrayXd {
    return products(way, -change) / squares(way).max(1e-300);
  };
  const auto bounded = [this](const Eigen::ArrayXd& rate) -> Eigen::ArrayXd { return rate.max(1 / slowest_).min(1.0); };
  const Eigen::ArrayXd of_period = size(drift_), noise = roundoff_of_drift * size(begin_),
                       in_period = bounded(fall_over(drift_, drift - drift_));
  if (jump_.size() == 0) return lambda_ = in_period;
  lambda_ = (size(jump_) > of_period.max(noise))
                .select(bounded(fall_over(jump_, drift - drift_of_jump_)),
                        (of_period * in_period > noise).select(in_period, lambda_));
  return (of_period * lambda_ > noise).select(lambda_.max(in_period), lambda_);
}

void CreepJump::after_period(SpringState& state) {
  if (!needed_) return;
  if (slowest_ > longest_creep)
    throw std::runtime_error("the springs creep for " + std::to_string(slowest_) +
                             " periods, which no period tells from rest within roundoff: set the Duration of the test, "
                             "so that branches slower than it are springs");
  const Eigen::ArrayXXd end = packed(state);
  if (begin_.size() == 0) {
    begin_ = end;
    return;
  }
  const Eigen::ArrayXXd drift = end - begin_;
  begin_ = end;
  if (++n_periods_ < periods_of_a_jump) {
    drift_ = drift;
    return;
  }
  n_periods_ = 0;
  const SpringState before = state;
  const Eigen::ArrayXXd jump = drift.colwise() * (1 / rates(drift) - 1);
  move_by(jump, state);
  if (jump_.size() > 0) to_come_ = change_of_tractions(before, state, mu_);
  drift_of_jump_ = drift;
  begin_ = packed(state);
  jump_ = jump;
}

}  // namespace fretval::mdr
