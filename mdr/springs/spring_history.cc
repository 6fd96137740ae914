#include "mdr/springs/spring_history.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "mdr/springs/force_balance.h"
#include "mdr/springs/repetition.h"
#include "mdr/springs/spring_energy.h"
#include "mdr/springs/spring_stick.h"
#include "mdr/support/checks.h"
#include "mdr/support/wide_registers.h"

namespace fretval::mdr {

namespace {

// Running minimum of a sampled signal per spring, at the vertex of the parabola through three samples.
class SampledMinimum {
 public:
  explicit SampledMinimum(Eigen::Index n)
      : least_(Eigen::ArrayXd::Constant(n, infinity)), before_(least_), last_(least_), n_samples_(0) {}

  // sample(j): of spring j. One pass without a branch in it, so that the compiler vectorises it.
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

struct Margins {
  SampledMinimum forward, backward;

  explicit Margins(Eigen::Index n) : forward(n), backward(n) {}

  void add(const SpringState& state, double mu) {
    const double limit = 1.5 * mu, *normal = state.normal_load.data(), *tangential = state.tangential_load.data();
    forward.add([=](Eigen::Index j) { return limit * normal[j] - tangential[j]; });
    backward.add([=](Eigen::Index j) { return limit * normal[j] + tangential[j]; });
  }
};

void check(const HistoryControl& control) {
  require_positive("period", control.period);
  require_within("steps per period", control.steps_per_period, 4, 1e6);
  require_within("ramp periods", control.n_ramp_periods, 1, 1e6);
  require_within("largest number of periods", control.max_periods, control.n_ramp_periods + 1, 1e9);
  require_positive("periodicity", control.periodicity);
}

double start_indentation(const SpringBed& bed, const PronyBody& body, const Loading& loading) {
  return loading.normal_force ? relaxed_indentation(bed, body, loading.normal_force(0)) : loading.path(0).indentation;
}

void check(const Loading& loading) {
  if (!loading.path && !(loading.normal_force && loading.tangential_force))
    throw std::invalid_argument("loading without a path: it needs both forces");
}

class History {
 public:
  History(const SpringBed& bed, const PronyBody& body, double mu, const Loading& loading, const HistoryControl& control)
      : bed_(bed),
        body_(body),
        mu_(mu),
        loading_(loading),
        control_(control),
        dt_(control.period / control.steps_per_period),
        step_(body, mu, dt_),
        axis_weights_(axis_weights(bed)),
        state_(relaxed_state(bed, body, start_indentation(bed, body, loading))),
        first_slip_(bed.depth.size()),
        slip_path_(Eigen::ArrayXd::Zero(bed.depth.size())) {}

  SpringHistory run() {
    Repetition repetition(body_, control_.periodicity);
    double change = 0;
    for (int period = 0; period < control_.max_periods; ++period) {
      start_ = state_;
      step_through(period);
      if (period < control_.n_ramp_periods) continue;
      change = change_of_tractions(start_, state_, mu_);
      const bool repeats = repetition.reached(change);
      if (repeats || (control_.slips_little && control_.slips_little(slip_of_periods_.back())))
        return measured_again(period);
    }
    std::ostringstream message;
    const auto& times = body_.branch_times;
    const double longest = times.empty() ? 0 : *std::max_element(times.begin(), times.end());
    message << "loads of the springs still change by " << change << " of the largest per period after "
            << control_.max_periods << " periods; the longest relaxation time lasts " << longest / control_.period
            << " periods: allow more periods, or leave out branches that are slow beyond interest";
    throw std::runtime_error(message.str());
  }

 private:
  [[nodiscard]] double time_of(int period, int step) const {
    return (period + static_cast<double>(step) / control_.steps_per_period) * control_.period;
  }

  void step_to(double time) {
    try {
      step_.advance(state_, bed_, indenter(time));
    } catch (GrossSlip& slip) {
      slip.time = time;
      throw;
    }
  }

  void see_step(Eigen::ArrayXd& slip_path) {
    slip_path += state_.slip.abs();
    largest_shift_ = std::max(largest_shift_, std::abs(state_.indenter.tangential));
    if (control_.watches_first_slip) first_slip_.add(state_, mu_);
  }

  void step_through(int period) {
    Eigen::ArrayXd slip_path = Eigen::ArrayXd::Zero(bed_.depth.size());
    for (int k = 1; k <= control_.steps_per_period; ++k) {
      step_to(time_of(period, k));
      in_wide_registers([&] { see_step(slip_path); });
    }
    slip_path_ += slip_path;
    slip_of_periods_.push_back(std::move(slip_path));
  }

  // The last period once more, from its start: measuring takes longer than stepping, and which is the last one, its end
  // tells.
  SpringHistory measured_again(int period) {
    std::swap(state_, start_);
    SpringHistory result{};
    result.n_periods = period + 1;
    result.deepest = result.highest = state_;
    result.mean_traction = Eigen::ArrayXd::Zero(bed_.depth.size());
    Margins margins(bed_.depth.size());
    record(result, time_of(period, 0), margins);
    for (int k = 1; k <= control_.steps_per_period; ++k) {
      const double time = time_of(period, k);
      before_ = state_;
      step_to(time);
      result.mean_traction += state_.tangential_load;
      const Dissipation heat = dissipation(bed_, body_, mu_, dt_, before_, state_);
      result.friction_work += heat.friction;
      result.bulk_work += heat.bulk;
      record(result, time, margins);
      add_work_of_last_step(result);
    }
    finish(result, margins);
    return result;
  }

  [[nodiscard]] IndenterState indenter(double time) const {
    PrescribedInStep prescribed{loading_.path ? loading_.path(time) : state_.indenter, {}, {}};
    if (loading_.normal_force) prescribed.normal_load = loading_.normal_force(time) / normal_scale(body_);
    if (loading_.tangential_force)
      prescribed.tangential_load = loading_.tangential_force(time) / tangential_scale(body_);
    return balanced(step_, state_, bed_, prescribed);
  }

  void record(SpringHistory& result, double time, Margins& margins) {
    margins.add(state_, mu_);
    if (state_.indenter.indentation > result.deepest.indenter.indentation) result.deepest = state_;
    if (state_.indenter.indentation < result.highest.indenter.indentation) result.highest = state_;
    result.time.push_back(time);
    result.indentation.push_back(state_.indenter.indentation);
    result.tangential_displacement.push_back(state_.indenter.tangential);
    // A prescribed one is balanced by whole springs.
    const double at_edge = loading_.normal_force ? 0 : edge_force(bed_, body_, state_);
    result.normal_force.push_back(normal_force(bed_, body_, state_) + at_edge);
    result.tangential_force.push_back(tangential_force(bed_, body_, state_));
    result.axis_pressure.push_back(axis_pressure(axis_weights_, body_, state_));
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
                                   ? stick_depth(bed_, mu_, first, slip_path_, never_slipped * largest_shift_)
                                   : std::nan("");
    result.depths.shakedown = stick_depth(bed_, mu_, shakedown, result.slip_amplitude, shaken_down * largest_shift_);
    result.settling_depth = stick_depth(bed_, mu_, shakedown, result.slip_amplitude, settling_slip * largest_shift_);
    result.largest_shift = largest_shift_;
    result.last = state_;
  }

  const SpringBed& bed_;
  const PronyBody& body_;
  double mu_;
  const Loading& loading_;
  const HistoryControl& control_;
  double dt_;
  SpringStep step_;
  Eigen::ArrayXd axis_weights_;
  SpringState state_, start_, before_;  // now, at the start of the period, a step ago
  Margins first_slip_;
  Eigen::ArrayXd slip_path_;  // from rest on
  std::vector<Eigen::ArrayXd> slip_of_periods_;
  double largest_shift_ = 0;
};

}  // namespace

double amplitude_share(double time, double ramp_duration) {
  const double x = std::clamp(time / ramp_duration, 0.0, 1.0);
  return x * x * x * (10 + x * (-15 + 6 * x));
}

double amplitude_share_rate(double time, double ramp_duration) {
  const double x = std::clamp(time / ramp_duration, 0.0, 1.0);
  return 30 * x * x * (1 - x) * (1 - x) / ramp_duration;
}

IndenterPath ramped_path(const HarmonicMotion& motion, double ramp_duration) {
  return ramped_path(RepeatingMotion{motion, 0}, ramp_duration);
}

IndenterPath ramped_path(const RepeatingMotion& repeating, double ramp_duration) {
  validate(repeating.motion);
  require_positive("ramp duration", ramp_duration);
  return [repeating, ramp_duration](double time) -> IndenterState {
    const double envelope = amplitude_share(time, ramp_duration),
                 envelope_rate = amplitude_share_rate(time, ramp_duration);
    const auto add = [&](const std::vector<Harmonic>& harmonics, double at, double rate_of_time, double& position,
                         double& rate) {
      for (const Harmonic& harmonic : harmonics) {
        const double omega = angular_frequency(harmonic.frequency), angle = omega * at + harmonic.phase;
        position += harmonic.amplitude * envelope * std::cos(angle);
        rate +=
            harmonic.amplitude * (envelope_rate * std::cos(angle) - envelope * omega * rate_of_time * std::sin(angle));
      }
    };
    IndenterState state{repeating.motion.indentation, 0, 0, 0};
    add(repeating.motion.normal, time, 1, state.indentation, state.indentation_rate);
    add(repeating.motion.tangential, time + repeating.lag_at(time), 1 + repeating.lag_rate_at(time), state.tangential,
        state.tangential_rate);
    return state;
  };
}

int periods_of_creep(const PronyBody& body, double period) {
  constexpr double many_creep_times = 10;
  double creep = body.viscosity;
  for (std::size_t i = 0; i < body.branch_times.size(); ++i) creep += body.branch_moduli[i] * body.branch_times[i];
  return static_cast<int>(std::ceil(many_creep_times * creep / body.relaxed_modulus / period));
}

ForcePath ramped_force(double mean, double amplitude, double frequency, double phase, double ramp_duration) {
  require_non_negative("mean force", mean);
  require_non_negative("force amplitude", amplitude);
  require_positive("frequency", frequency);
  require_finite("phase", phase);
  require_positive("ramp duration", ramp_duration);
  return [=](double time) {
    return mean +
           amplitude * amplitude_share(time, ramp_duration) * std::cos(angular_frequency(frequency) * time + phase);
  };
}

SpringHistory spring_history(const SpringBed& bed, const PronyBody& body, double mu, const Loading& loading,
                             const HistoryControl& control) {
  check(control);
  check(loading);
  return History(bed, body, mu, loading, control).run();
}

}  // namespace fretval::mdr
