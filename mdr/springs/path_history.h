#pragma once

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "mdr/motion/sampled_path.h"
#include "mdr/springs/creep_jump.h"
#include "mdr/springs/force_balance.h"
#include "mdr/springs/path_data.h"
#include "mdr/springs/repetition.h"
#include "mdr/springs/spring_energy.h"
#include "mdr/springs/spring_history.h"
#include "mdr/springs/spring_stick.h"
#include "mdr/springs/stepped_history.h"

namespace fretval::mdr {

/// A path whose departure from rest rises over the ramp. Where a force is prescribed it stands in the place of the
/// displacement, in N.
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

  void add(const SpringState& state, double friction_limit) {
    const Eigen::ArrayXd limit = friction_limit * state.normal_load;
    forward = forward.min(limit - state.tangential_load);
    backward = backward.min(limit + state.tangential_load);
  }
};

/// Steps a foundation of springs along a path: what independent springs (mdr/springs/path_response.h) and those that a
/// layer couples (mdr/layer/coupled_path.h) have in common. A Foundation has
///
///   void add_piece(dt)                     steps of the next piece last so long, s
///   SpringState start(rest)                relaxed, at the rest of the path
///   void advance(state, piece, prescribed) by one step of a piece
///   double normal_scale(), tangential_scale()        N per sum(width * load)
///   double friction_limit()                mu E*/G*
///   const SpringBed& bed()
///   SpringForces forces(state)             on the indenter
///   Dissipation heat(dt, before, after)    of one step
///   double stick_depth(margin, slip)       see mdr/springs/spring_stick.h
template <class Foundation>
class PathHistory {
 public:
  PathHistory(Foundation springs, const PronyBody& body, double mu, const SampledPath& path,
              const PathFineness& fineness)
      : springs_(std::move(springs)),
        body_(body),
        mu_(mu),
        path_(path),
        fineness_(fineness),
        rising_{path, rest_of(path), path.repeats ? fineness.n_ramp_periods * path.duration() : 0},
        state_(springs_.start(rising_.rest)),
        first_slip_(state_.normal_load.size()) {
    constexpr double roundoff = 1e-12;
    for (std::size_t k = 0; k < path.n_pieces(); ++k) {
      const double duration = path.time[k + 1] - path.time[k];
      const double wanted = fineness.steps_per_duration * duration / path.duration() * (1 - roundoff);
      n_steps_.push_back(fineness.subdivisions * std::max(1, static_cast<int>(std::ceil(wanted))));
      springs_.add_piece(duration / n_steps_.back());
    }
  }

  PathCourse run() {
    if (!path_.repeats) return {springs_.bed(), one_period(0)};
    CreepJump jump(body_, mu_, path_.duration());
    Repetition repetition(body_, periodicity_of(body_, fineness_.periodicity, fineness_.subdivisions));
    const int most_periods = most_periods_with(fineness_.n_ramp_periods);
    for (int period = 0; period < most_periods; ++period) {
      const SpringState start = state_;
      SpringHistory last = one_period(period);
      if (period < fineness_.n_ramp_periods) continue;
      if (repetition.reached(std::max(change_of_tractions(start, state_, mu_), jump.to_come())))
        return {springs_.bed(), std::move(last)};
      jump.after_period(state_);
    }
    throw std::runtime_error("loads of the springs along the path do not repeat after " + std::to_string(most_periods) +
                             " periods: set the Duration of the test, so that branches slower than it are springs");
  }

 private:
  SpringHistory one_period(int period) {
    SpringHistory result{};
    result.n_periods = period + 1;
    result.deepest = result.highest = state_;
    result.mean_traction = Eigen::ArrayXd::Zero(state_.normal_load.size());
    LeastMargins margins(state_.normal_load.size());
    record(result, path_.time.front(), margins);
    for (std::size_t piece = 0; piece < path_.n_pieces(); ++piece)
      for (int j = 1; j <= n_steps_[piece]; ++j) {
        const double duration = path_.time[piece + 1] - path_.time[piece], s = duration * j / n_steps_[piece],
                     time = path_.time[piece] + s;
        const double dt = duration / n_steps_[piece];
        const SpringState before = state_;
        step(piece, dt, rising_.at(piece, s, period * path_.duration() + time - path_.time.front()),
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

  /// One step of dt in s of a piece. prescribed: displacements or forces at the end of the step, at `time` in s.
  void step(std::size_t piece, double dt, const IndenterState& prescribed, double time) {
    if (!path_.has_forces()) return springs_.advance(state_, piece, {prescribed, {}, {}});
    go_on_at_rates(dt, prescribed);
    PrescribedInStep in_step{prescribed, {}, {}};
    if (path_.normal_force) in_step.normal_load = prescribed.indentation / springs_.normal_scale();
    if (path_.tangential_force) in_step.tangential_load = prescribed.tangential / springs_.tangential_scale();
    const double spare = springs_.friction_limit() * (springs_.bed().width * state_.normal_load).sum() -
                         std::abs((springs_.bed().width * state_.tangential_load).sum());
    try {
      springs_.advance(state_, piece, in_step);
    } catch (GrossSlip& slip) {
      slip.time = time - dt * slip.excess / (slip.excess + spare);
      slip.amplitude =
          path_.repeats ? std::min(1.0, amplitude_share(slip.time - path_.time.front(), rising_.ramp_duration)) : 1;
      throw;
    }
    dt_before_ = dt;
  }

  /// SpringStep::arrived() takes the rates of the indenter from its last two positions, for steps of equal length. Here
  /// the earlier position is set such that these are the known rates in a direction whose displacement is prescribed,
  /// and those of the last step, whatever its length, in a direction whose force is.
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
    const auto heat = springs_.heat(dt, before, state_);
    result.friction_work += heat.friction;
    result.bulk_work += heat.bulk;
  }

  void record(SpringHistory& result, double time, LeastMargins& margins) {
    margins.add(state_, springs_.friction_limit());
    first_slip_.add(state_, springs_.friction_limit());
    if (state_.indenter.indentation > result.deepest.indenter.indentation) result.deepest = state_;
    if (state_.indenter.indentation < result.highest.indenter.indentation) result.highest = state_;
    result.time.push_back(time);
    result.indentation.push_back(state_.indenter.indentation);
    result.tangential_displacement.push_back(rising_.rest.tangential + state_.indenter.tangential);
    const SpringForces forces = springs_.forces(state_);
    result.normal_force.push_back(forces.normal);
    result.tangential_force.push_back(forces.tangential);
    result.axis_pressure.push_back(forces.axis_pressure);
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
    result.depths.first_slip = springs_.stick_depth(first, {first_slip_.slip_path, never_slipped * largest_shift_, 1});
    if (path_.repeats) {
      const auto depth = [&](double allowed) {
        return springs_.stick_depth(shakedown, {margins.slip_path, allowed * largest_shift_, to_and_fro});
      };
      result.depths.shakedown = depth(shaken_down);
      result.settling_depth = depth(settling_slip);
    }
    result.largest_shift = largest_shift_;
    result.slip_amplitude = margins.slip_path;
  }

  Foundation springs_;
  const PronyBody& body_;
  double mu_;
  const SampledPath& path_;
  PathFineness fineness_;
  RisingPath rising_;
  std::vector<int> n_steps_;  // by piece
  SpringState state_;
  LeastMargins first_slip_;
  double largest_shift_ = 0;
  double dt_before_ = 0;  // s, of the last step in which a force was prescribed; 0: none yet
};

/// Throws std::invalid_argument.
void validate_along_path(const SampledPath& path, const PathFineness& fineness);

/// Largest and mean values, works and depths of stick zones of a history.
PathForces forces_of(const SpringHistory& history);

/// Replaces the forces of the finer computation by what it and the coarse one tend to with second order, and sets the
/// error to their difference.
void extrapolate(const PathForces& coarse, SteppedPathForces& stepped);

/// The absolute difference of each number.
PathForces distance(const PathForces& one, const PathForces& other);

/// path_forces() for springs of any kind. course_of(fineness): the PathCourse of these springs.
template <class CourseOf>
SteppedPathForces extrapolated_path_forces(const PronyBody& body, const SampledPath& path, PathFineness coarse,
                                           const CourseOf& course_of) {
  validate(path);
  if (path.has_forces())
    coarse.n_ramp_periods = std::max(coarse.n_ramp_periods, periods_of_creep(body, path.duration()));
  auto fine = coarse;
  fine.n_springs *= 2;
  fine.subdivisions *= 2;
  fine.n_ramp_periods *= 2;
  const auto first = forces_of(course_of(coarse).history);
  auto course = course_of(fine);
  SteppedPathForces stepped{forces_of(course.history), {}, std::move(course)};
  extrapolate(first, stepped);
  return stepped;
}

}  // namespace fretval::mdr
