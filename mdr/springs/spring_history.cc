#include "mdr/springs/spring_history.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "mdr/springs/force_balance.h"
#include "mdr/springs/spring_energy.h"
#include "mdr/springs/spring_stick.h"
#include "mdr/springs/stepped_history.h"
#include "mdr/support/checks.h"

namespace fretval::mdr {

namespace {

double start_indentation(const SpringBed& bed, const PronyBody& body, const Loading& loading) {
  return loading.normal_force ? relaxed_indentation(bed, body, loading.normal_force(0)) : loading.path(0).indentation;
}

class IndependentSprings {
 public:
  IndependentSprings(const SpringBed& bed, const PronyBody& body, double mu, const Loading& loading,
                     const HistoryControl& control)
      : bed_(bed),
        body_(body),
        mu_(mu),
        loading_(loading),
        dt_(control.period / control.steps_per_period),
        step_(body, mu, dt_),
        axis_weights_(axis_weights(bed)) {}

  [[nodiscard]] SpringState start() const {
    return relaxed_state(bed_, body_, start_indentation(bed_, body_, loading_));
  }

  void advance(SpringState& state, double time) const { step_.advance(state, bed_, indenter(state, time)); }

  [[nodiscard]] double friction_limit() const { return 1.5 * mu_; }

  [[nodiscard]] SpringForces forces(const SpringState& state) const {
    return forces_of_springs(bed_, body_, axis_weights_, state, by_force());
  }

  [[nodiscard]] Dissipation heat(const SpringState& before, const SpringState& after) const {
    return dissipation(widths_in_step(bed_, body_, before, after, by_force()), body_, mu_, dt_, before, after);
  }

  [[nodiscard]] double stick_depth(const Eigen::ArrayXd& margin, const SlipOfSprings& slip) const {
    return mdr::stick_depth(bed_, mu_, margin, slip);
  }

 private:
  [[nodiscard]] ByForce by_force() const {
    return {static_cast<bool>(loading_.normal_force), static_cast<bool>(loading_.tangential_force)};
  }
  [[nodiscard]] IndenterState indenter(const SpringState& state, double time) const {
    PrescribedInStep prescribed{loading_.path ? loading_.path(time) : state.indenter, {}, {}};
    if (loading_.normal_force) prescribed.normal_load = loading_.normal_force(time) / normal_scale(body_);
    if (loading_.tangential_force)
      prescribed.tangential_load = loading_.tangential_force(time) / tangential_scale(body_);
    return balanced(step_, state, bed_, prescribed);
  }

  const SpringBed& bed_;
  const PronyBody& body_;
  double mu_;
  const Loading& loading_;
  double dt_;
  SpringStep step_;
  Eigen::ArrayXd axis_weights_;
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
  constexpr double many_creep_times = 10, most = 1e8;  // fits an int, with any fineness
  double creep = body.viscosity;
  for (std::size_t i = 0; i < body.branch_times.size(); ++i) creep += body.branch_moduli[i] * body.branch_times[i];
  return static_cast<int>(std::min(std::ceil(many_creep_times * creep / body.relaxed_modulus / period), most));
}

int most_periods_with(int n_periods) {
  constexpr int usual = 2000, most = 10'000;
  if (n_periods > most)
    throw std::runtime_error("the springs creep for " + std::to_string(n_periods) +
                             " periods, which are too many to step: set the Duration of the test, so that branches "
                             "slower than it are springs");
  return std::max(usual, 2 * n_periods);
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
  validate(control);
  validate(loading);
  const IndependentSprings springs(bed, body, mu, loading, control);
  return SteppedHistory<IndependentSprings>(springs, body, mu, control).run();
}

}  // namespace fretval::mdr
