#pragma once

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

#include "mdr/springs/creep_jump.h"
#include "mdr/springs/history_data.h"
#include "mdr/springs/repetition.h"
#include "mdr/springs/spring_energy.h"
#include "mdr/springs/spring_stick.h"
#include "mdr/support/checks.h"
#include "mdr/support/wide_registers.h"

namespace fretval::mdr {

/// Throw std::invalid_argument unless a history can be stepped with this control, under this loading.
inline void validate(const HistoryControl& control) {
  require_positive("period", control.period);
  require_within("steps per period", control.steps_per_period, 4, 1e6);
  require_within("ramp periods", control.n_ramp_periods, 1, 1e6);
  require_within("largest number of periods", control.max_periods, control.n_ramp_periods + 1, 1e9);
  require_positive("periodicity", control.periodicity);
}

inline void validate(const Loading& loading) {
  if (!loading.path && !(loading.normal_force && loading.tangential_force))
    throw std::invalid_argument("loading without a path: it needs both forces");
}

/// Running minimum of a sampled signal per spring, at the vertex of the parabola through three samples.
class SampledMinimum {
 public:
  explicit SampledMinimum(Eigen::Index n)
      : least_(Eigen::ArrayXd::Constant(n, infinity)), before_(least_), last_(least_), n_samples_(0) {}

  // sample(j): the new sample of spring j. The loop is one pass without a branch, so that the compiler vectorises it.
  template <class Sample>
  void add(const Sample& sample) {
    const bool has_parabola = n_samples_++ >= 2;
    double *least = least_.data(), *before = before_.data(), *last = last_.data();
#pragma GCC ivdep
    for (Eigen::Index j = 0, n = least_.size(); j < n; ++j) {
      const double now = sample(j), bend = before[j] - 2 * last[j] + now, slope = (now - before[j]) / 2;
      const double vertex = last[j] - slope * slope / (2 * bend), lower = std::min(least[j], now);
      const bool turns = has_parabola && last[j] < before[j] && last[j] <= now;
      least[j] = turns ? std::min(lower, vertex) : lower;
      before[j] = last[j];
      last[j] = now;
    }
  }

  [[nodiscard]] const Eigen::ArrayXd& value() const {
    return least_;
  }

 private:
  static constexpr double infinity = 1e300;
  Eigen::ArrayXd least_, before_, last_;
  int n_samples_;
};

/// Least friction margin of each spring against slip in either direction, m.
struct Margins {
  SampledMinimum forward, backward;

  explicit Margins(Eigen::Index n) : forward(n), backward(n) {}

  void add(const SpringState& state, double limit) {
    const double *normal = state.normal_load.data(), *tangential = state.tangential_load.data();
    forward.add([=](Eigen::Index j) { return limit * normal[j] - tangential[j]; });
    backward.add([=](Eigen::Index j) { return limit * normal[j] + tangential[j]; });
  }
};

/// Steps a foundation of springs until its tractions repeat and its stick zone grows no more, and measures the last
/// period: what independent springs
/// (mdr/springs/spring_history.h) and those that a layer couples (mdr/layer/coupled_history.h) have in common. A
/// Foundation has
///
///   SpringState start()                    relaxed, at time 0
///   void advance(SpringState&, time)       by one step, to this time; throws GrossSlip
///   double friction_limit()                mu E*/G*: largest tangential load over the normal one
///   SpringForces forces(state)             on the indenter
///   Dissipation heat(before, after)        of one step
///   double stick_depth(margin, slip)       see mdr/springs/spring_stick.h
///
/// All of them const: what a foundation remembers is in the state.
template <class Foundation>
class SteppedHistory {
 public:
  SteppedHistory(const Foundation& foundation, const PronyBody& body, double mu, const HistoryControl& control)
      : foundation_(foundation),
        body_(body),
        mu_(mu),
        control_(control),
        state_(foundation.start()),
        first_slip_(state_.normal_load.size()),
        slip_path_(Eigen::ArrayXd::Zero(state_.normal_load.size())) {}

  SpringHistory run() {
    CreepJump jump(body_, mu_, control_.period);
    Repetition repetition(body_, control_.periodicity);
    double change = 0;
    for (int period = 0; period < control_.max_periods; ++period) {
      start_ = state_;
      step_through(period);
      if (period < control_.n_ramp_periods) continue;
      change = change_of_tractions(start_, state_, mu_);
      const bool settles =
          still_settles(slip_of_periods_, settling_slip * largest_shift_) && period + 1 < control_.max_periods;
      const bool repeats = repetition.reached(std::max(change, jump.to_come())) && !settles;
      if (repeats || (control_.slips_little && control_.slips_little(slip_of_periods_.back())))
        return measured_again(period);
      // With slips_little the slip of every period is asked for, so that none may be jumped over.
      if (!control_.slips_little) jump.after_period(state_);
    }
    std::ostringstream message;
    const auto& times = body_.branch_times;
    const double longest = times.empty() ? 0 : *std::max_element(times.begin(), times.end());
    message
        << "loads of the springs still change by " << change << " of the largest per period after "
        << control_.max_periods << " periods; the longest relaxation time lasts " << longest / control_.period
        << " periods: allow more periods, or set the Duration of the test, so that branches slower than it are springs";
    throw std::runtime_error(message.str());
  }

 private:
  [[nodiscard]] double time_of(int period, int step) const {
    return (period + static_cast<double>(step) / control_.steps_per_period) * control_.period;
  }

  void step_to(double time) {
    try {
      foundation_.advance(state_, time);
    } catch (GrossSlip& slip) {
      slip.time = time;
      throw;
    }
  }

  void see_step(Eigen::ArrayXd& slip_path) {
    slip_path += state_.slip.abs();
    largest_shift_ = std::max(largest_shift_, std::abs(state_.indenter.tangential));
    if (control_.watches_first_slip) first_slip_.add(state_, foundation_.friction_limit());
  }

  void step_through(int period) {
    Eigen::ArrayXd slip_path = Eigen::ArrayXd::Zero(state_.normal_load.size());
    for (int k = 1; k <= control_.steps_per_period; ++k) {
      step_to(time_of(period, k));
      in_wide_registers([&] { see_step(slip_path); });
    }
    slip_path_ += slip_path;
    slip_of_periods_.push_back(std::move(slip_path));
  }

  // Steps the last period once more from its start, and measures it: measuring takes longer than stepping, and that a
  // period is the last one shows only at its end.
  SpringHistory measured_again(int period) {
    std::swap(state_, start_);
    SpringHistory result{};
    result.n_periods = period + 1;
    result.deepest = result.highest = state_;
    result.mean_traction = Eigen::ArrayXd::Zero(state_.normal_load.size());
    Margins margins(state_.normal_load.size());
    record(result, time_of(period, 0), margins);
    for (int k = 1; k <= control_.steps_per_period; ++k) {
      const double time = time_of(period, k);
      before_ = state_;
      step_to(time);
      result.mean_traction += state_.tangential_load;
      const Dissipation heat = foundation_.heat(before_, state_);
      result.friction_work += heat.friction;
      result.bulk_work += heat.bulk;
      record(result, time, margins);
      add_work_of_last_step(result);
    }
    finish(result, margins);
    return result;
  }

  void record(SpringHistory& result, double time, Margins& margins) {
    margins.add(state_, foundation_.friction_limit());
    if (state_.indenter.indentation > result.deepest.indenter.indentation) result.deepest = state_;
    if (state_.indenter.indentation < result.highest.indenter.indentation) result.highest = state_;
    result.time.push_back(time);
    result.indentation.push_back(state_.indenter.indentation);
    result.tangential_displacement.push_back(state_.indenter.tangential);
    const SpringForces forces = foundation_.forces(state_);
    result.normal_force.push_back(forces.normal);
    result.tangential_force.push_back(forces.tangential);
    result.axis_pressure.push_back(forces.axis_pressure);
  }

  void add_work_of_last_step(SpringHistory& result) const {
    const std::size_t k = result.time.size() - 1;
    const double fall = state_.indenter.indentation - before_.indenter.indentation;
    const double shift = state_.indenter.tangential - before_.indenter.tangential;
    const double tangential = (result.tangential_force[k - 1] + result.tangential_force[k]) / 2 * shift;
    result.indenter_work += (result.normal_force[k - 1] + result.normal_force[k]) / 2 * fall + tangential;
    result.tangential_work += tangential;
  }

  void finish(SpringHistory& result, const Margins& margins) {
    result.slip_amplitude = slip_of_periods_.back();
    result.slip_of_periods = std::move(slip_of_periods_);
    result.mean_traction /= control_.steps_per_period;
    const Eigen::ArrayXd first = first_slip_.forward.value().min(first_slip_.backward.value());
    const Eigen::ArrayXd shakedown = (margins.forward.value() + margins.backward.value()) / 2;
    result.depths.first_slip = control_.watches_first_slip
                                   ? foundation_.stick_depth(first, {slip_path_, never_slipped * largest_shift_, 1})
                                   : std::nan("");
    const auto depth = [&](double allowed) {
      return foundation_.stick_depth(shakedown, {result.slip_amplitude, allowed * largest_shift_, to_and_fro});
    };
    result.depths.shakedown = depth(shaken_down);
    result.settling_depth = depth(settling_slip);
    result.largest_shift = largest_shift_;
    result.last = state_;
  }

  const Foundation& foundation_;
  const PronyBody& body_;
  double mu_;
  const HistoryControl& control_;
  SpringState state_, start_{}, before_{};  // now, at the start of the period, a step ago
  Margins first_slip_;
  Eigen::ArrayXd slip_path_;  // from rest on
  std::vector<Eigen::ArrayXd> slip_of_periods_;
  double largest_shift_ = 0;
};

}  // namespace fretval::mdr
