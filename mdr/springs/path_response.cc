#include "mdr/springs/path_response.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "mdr/motion/force_control.h"
#include "mdr/springs/force_balance.h"
#include "mdr/springs/repetition.h"
#include "mdr/springs/spring_energy.h"
#include "mdr/springs/spring_history.h"
#include "mdr/springs/spring_stick.h"
#include "mdr/support/checks.h"

namespace fretval::mdr {
namespace {

constexpr int most_periods_of_path = 2000;
constexpr double roundoff_of_count = 1e-12;

/// The path, its departure from rest rising over the ramp. A force stands in the place of the displacement.
struct RisingPath {
  const SampledPath& path;
  PathRest rest;
  double ramp_duration;  ///< s; 0: none

  [[nodiscard]] IndenterState at(std::size_t piece, double s, double since_start) const {
    const double duration = path.time[piece + 1] - path.time[piece];
    double share = 1, share_rate = 0;
    if (since_start < ramp_duration) {
      share = amplitude_share(since_start, ramp_duration);
      share_rate = amplitude_share_rate(since_start, ramp_duration);
    }
    IndenterState state{rest.normal, 0, 0, 0};
    const auto add = [&](const std::vector<double>& values, double mean, double& position, double& rate) {
      const double slope = (values[piece + 1] - values[piece]) / duration, departure = values[piece] + slope * s - mean;
      position += share * departure;
      rate = share * slope + share_rate * departure;
    };
    add(path.normal, rest.normal, state.indentation, state.indentation_rate);
    add(path.tangential, rest.tangential, state.tangential, state.tangential_rate);
    return state;
  }
};

struct LeastMargins {
  Eigen::ArrayXd forward, backward, slip_path;

  explicit LeastMargins(Eigen::Index n)
      : forward(Eigen::ArrayXd::Constant(n, 1e300)), backward(forward), slip_path(Eigen::ArrayXd::Zero(n)) {}

  void add(const SpringState& state, double mu) {
    const Eigen::ArrayXd limit = 1.5 * mu * state.normal_load;
    forward = forward.min(limit - state.tangential_load);
    backward = backward.min(limit + state.tangential_load);
  }
};

class Course {
 public:
  Course(SpringBed bed, const PronyBody& body, double mu, const SampledPath& path, const PathFineness& fineness)
      : bed_(std::move(bed)),
        axis_weights_(axis_weights(bed_)),
        body_(body),
        mu_(mu),
        path_(path),
        fineness_(fineness),
        rising_{path, rest_of(path), path.repeats ? fineness.n_ramp_periods * path.duration() : 0},
        state_(relaxed_state(
            bed_, body,
            path.normal_force ? relaxed_indentation(bed_, body, rising_.rest.normal) : rising_.rest.normal)),
        first_slip_(bed_.depth.size()) {
    for (std::size_t k = 0; k < path.n_pieces(); ++k) {
      const double duration = path.time[k + 1] - path.time[k];
      const double wanted = fineness.steps_per_duration * duration / path.duration() * (1 - roundoff_of_count);
      n_steps_.push_back(fineness.subdivisions * std::max(1, static_cast<int>(std::ceil(wanted))));
      steps_.emplace_back(body, mu, duration / n_steps_.back());
    }
  }

  PathCourse run() {
    if (!path_.repeats) return {bed_, one_period(0)};
    Repetition repetition(body_, periodicity_of(body_, fineness_.periodicity, fineness_.subdivisions));
    for (int period = 0; period < most_periods_of_path; ++period) {
      const SpringState start = state_;
      SpringHistory last = one_period(period);
      if (period < fineness_.n_ramp_periods) continue;
      if (repetition.reached(change_of_tractions(start, state_, mu_))) return {bed_, std::move(last)};
    }
    throw std::runtime_error("loads of the springs along the path do not repeat after 2000 periods");
  }

 private:
  SpringHistory one_period(int period) {
    SpringHistory result{};
    result.n_periods = period + 1;
    result.deepest = result.highest = state_;
    result.mean_traction = Eigen::ArrayXd::Zero(bed_.depth.size());
    LeastMargins margins(bed_.depth.size());
    record(result, path_.time.front(), margins);
    for (std::size_t piece = 0; piece < path_.n_pieces(); ++piece)
      for (int j = 1; j <= n_steps_[piece]; ++j) {
        const double duration = path_.time[piece + 1] - path_.time[piece], s = duration * j / n_steps_[piece],
                     time = path_.time[piece] + s;
        const double dt = duration / n_steps_[piece];
        const SpringState before = state_;
        step(steps_[piece], dt, rising_.at(piece, s, period * path_.duration() + time - path_.time.front()),
             period * path_.duration() + time);
        see_step(result, before, dt, margins);
        record(result, time, margins);
        add_work_of_last_step(result);
      }
    first_slip_.slip_path += margins.slip_path;
    finish(result, margins);
    result.last = state_;
    return result;
  }

  /// prescribed: at the end of the step, at a time in s.
  void step(const SpringStep& step, double dt, const IndenterState& prescribed, double time) {
    if (!path_.has_forces()) return step.advance(state_, bed_, prescribed);
    go_on_at_rates(dt, prescribed);
    PrescribedInStep in_step{prescribed, {}, {}};
    if (path_.normal_force) in_step.normal_load = prescribed.indentation / normal_scale(body_);
    if (path_.tangential_force) in_step.tangential_load = prescribed.tangential / tangential_scale(body_);
    const double spare =
        1.5 * mu_ * (bed_.width * state_.normal_load).sum() - std::abs((bed_.width * state_.tangential_load).sum());
    try {
      step.advance(state_, bed_, balanced(step, state_, bed_, in_step));
    } catch (GrossSlip& slip) {
      slip.time = time - dt * slip.excess / (slip.excess + spare);
      slip.amplitude =
          path_.repeats ? std::min(1.0, amplitude_share(slip.time - path_.time.front(), rising_.ramp_duration)) : 1;
      throw;
    }
    dt_before_ = dt;
  }

  /// SpringStep::arrived takes rates from the last two positions in steps as long as this one: of what is prescribed
  /// those that are known, of the others those of the last step, whatever its length.
  void go_on_at_rates(double dt, const IndenterState& to) {
    const auto &last = state_.indenter, &before = state_.indenter_before;
    const auto known = [dt](double now, double rate, double position) {
      return 2 * dt * rate - 3 * now + 4 * position;
    };
    const double scale = dt_before_ > 0 ? dt / dt_before_ : 1;
    IndenterState& changed = state_.indenter_before;
    changed.indentation = path_.normal_force ? last.indentation - scale * (last.indentation - before.indentation)
                                             : known(to.indentation, to.indentation_rate, last.indentation);
    changed.tangential = path_.tangential_force ? last.tangential - scale * (last.tangential - before.tangential)
                                                : known(to.tangential, to.tangential_rate, last.tangential);
  }

  void see_step(SpringHistory& result, const SpringState& before, double dt, LeastMargins& margins) {
    largest_shift_ = std::max(largest_shift_, std::abs(state_.indenter.tangential));
    margins.slip_path += state_.slip.abs();
    result.mean_traction += state_.tangential_load * (dt / path_.duration());
    const auto heat = dissipation(bed_, body_, mu_, dt, before, state_);
    result.friction_work += heat.friction;
    result.bulk_work += heat.bulk;
  }

  void record(SpringHistory& result, double time, LeastMargins& margins) {
    margins.add(state_, mu_);
    first_slip_.add(state_, mu_);
    if (state_.indenter.indentation > result.deepest.indenter.indentation) result.deepest = state_;
    if (state_.indenter.indentation < result.highest.indenter.indentation) result.highest = state_;
    result.time.push_back(time);
    result.indentation.push_back(state_.indenter.indentation);
    result.tangential_displacement.push_back(rising_.rest.tangential + state_.indenter.tangential);
    // A prescribed one is balanced by whole springs.
    const double at_edge = path_.normal_force ? 0 : edge_force(bed_, body_, state_);
    result.normal_force.push_back(normal_force(bed_, body_, state_) + at_edge);
    result.tangential_force.push_back(tangential_force(bed_, body_, state_));
    result.axis_pressure.push_back(axis_pressure(axis_weights_, body_, state_));
  }

  static void add_work_of_last_step(SpringHistory& result) {
    const std::size_t k = result.time.size() - 1;
    const auto trapezium = [k](const std::vector<double>& force, const std::vector<double>& way) {
      return (force[k - 1] + force[k]) / 2 * (way[k] - way[k - 1]);
    };
    const double tangential = trapezium(result.tangential_force, result.tangential_displacement);
    result.indenter_work += trapezium(result.normal_force, result.indentation) + tangential;
    result.tangential_work += tangential;
  }

  void finish(SpringHistory& result, const LeastMargins& margins) const {
    const Eigen::ArrayXd first = first_slip_.forward.min(first_slip_.backward),
                         shakedown = (margins.forward + margins.backward) / 2;
    const auto depth = [&](const Eigen::ArrayXd& margin, const Eigen::ArrayXd& slip_path, double allowed) {
      return stick_depth(bed_, mu_, margin, slip_path, allowed * largest_shift_);
    };
    result.depths.first_slip = depth(first, first_slip_.slip_path, never_slipped);
    if (path_.repeats) {
      result.depths.shakedown = depth(shakedown, margins.slip_path, shaken_down);
      result.settling_depth = depth(shakedown, margins.slip_path, settling_slip);
    }
    result.largest_shift = largest_shift_;
    result.slip_amplitude = margins.slip_path;
  }

  SpringBed bed_;
  Eigen::ArrayXd axis_weights_;
  const PronyBody& body_;
  double mu_;
  const SampledPath& path_;
  PathFineness fineness_;
  RisingPath rising_;
  std::vector<int> n_steps_;       // by piece
  std::vector<SpringStep> steps_;  // likewise
  SpringState state_;
  LeastMargins first_slip_;
  double largest_shift_ = 0;
  double dt_before_ = 0;  // of the last step under a force; 0: none
};

PathForces forces_of(const SpringHistory& history) {
  const auto &time = history.time, &pull = history.tangential_force, &normal = history.normal_force;
  double largest = 0, mean = 0;
  for (std::size_t k = 0; k < pull.size(); ++k) {
    largest = std::max(largest, std::abs(pull[k]));
    if (k > 0) mean += (time[k] - time[k - 1]) * (pull[k - 1] + pull[k]) / 2;
  }
  const auto &depth = history.indentation, &shift = history.tangential_displacement;
  const auto [least, most] = std::minmax_element(shift.begin(), shift.end());
  double way = 0;
  for (std::size_t k = 1; k < shift.size(); ++k) way += std::abs(shift[k] - shift[k - 1]);
  return {*std::max_element(normal.begin(), normal.end()),
          *std::min_element(normal.begin(), normal.end()),
          *std::max_element(history.axis_pressure.begin(), history.axis_pressure.end()),
          largest,
          mean / (time.back() - time.front()),
          history.friction_work,
          history.bulk_work,
          history.tangential_work,
          *std::max_element(depth.begin(), depth.end()),
          (*most - *least) / 2,
          way,
          history.depths.first_slip,
          history.settling_depth};
}

}  // namespace

PathCourse path_course(const Profile& profile, const PronyBody& body, double mu, const SampledPath& path,
                       const PathFineness& fineness) {
  validate(path);
  require_within("steps along a path", fineness.steps_per_duration, 1, 1e6);
  require_within("ramp periods", fineness.n_ramp_periods, 1, most_periods_of_path - 1);
  // No spring beyond: with a dashpot one that touches halfway would carry its jump of load over its whole width.
  const double outer = inverse_transform(profile, deepest_indentation(profile, body, path));
  return Course(spring_bed(profile, outer, fineness.n_springs), body, mu, path, fineness).run();
}

double deepest_indentation(const Profile& profile, const PronyBody& body, const SampledPath& path) {
  const double most = maximum_normal(path);
  return path.normal_force ? indentation_for_force(profile, body.relaxed_modulus, most) : most;
}

SteppedPathForces path_forces(const Profile& profile, const PronyBody& body, double mu, const SampledPath& path,
                              PathFineness coarse) {
  validate(path);
  if (path.has_forces())
    coarse.n_ramp_periods = std::max(coarse.n_ramp_periods, periods_of_creep(body, path.duration()));
  auto fine = coarse;
  fine.n_springs *= 2;
  fine.subdivisions *= 2;
  fine.n_ramp_periods *= 2;
  const auto first = forces_of(path_course(profile, body, mu, path, coarse).history);
  auto course = path_course(profile, body, mu, path, fine);
  SteppedPathForces stepped{forces_of(course.history), {}, std::move(course)};
  const auto extrapolate = [&](double PathForces::*part) {
    const double difference = stepped.forces.*part - first.*part;
    stepped.forces.*part += difference / 3;
    stepped.error.*part = std::abs(difference);
  };
  for (const auto part : {&PathForces::normal_force_max, &PathForces::normal_force_min, &PathForces::axis_pressure_max,
                          &PathForces::tangential_force_max, &PathForces::tangential_force_mean,
                          &PathForces::friction_work, &PathForces::bulk_work, &PathForces::tangential_work,
                          &PathForces::largest_indentation, &PathForces::tangential_amplitude,
                          &PathForces::tangential_way, &PathForces::first_slip, &PathForces::shakedown})
    extrapolate(part);
  return stepped;
}

}  // namespace fretval::mdr
