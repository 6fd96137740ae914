#include "mdr/springs/path_response.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "mdr/springs/spring_energy.h"
#include "mdr/springs/spring_history.h"
#include "mdr/springs/spring_stick.h"
#include "mdr/support/checks.h"

namespace fretval::mdr {
namespace {

constexpr int most_periods_of_path = 2000;
constexpr double roundoff_of_count = 1e-12, periodicity_with_dashpot = 1e-2;

/// The path, its departure from rest rising over the ramp.
struct RisingPath {
  const SampledPath& path;
  RestPosition rest;
  double ramp_duration;  ///< s; 0: none

  [[nodiscard]] IndenterState at(std::size_t piece, double s, double since_start) const {
    const double duration = path.time[piece + 1] - path.time[piece];
    double share = 1, share_rate = 0;
    if (since_start < ramp_duration) {
      const double x = since_start / ramp_duration;
      share = amplitude_share(since_start, ramp_duration);
      share_rate = 6 * x * (1 - x) / ramp_duration;
    }
    IndenterState state{rest.indentation, 0, 0, 0};
    const auto add = [&](const std::vector<double>& values, double mean, double& position, double& rate) {
      const double slope = (values[piece + 1] - values[piece]) / duration, departure = values[piece] + slope * s - mean;
      position += share * departure;
      rate = share * slope + share_rate * departure;
    };
    add(path.indentation, rest.indentation, state.indentation, state.indentation_rate);
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
        rising_{path, rest_position(path), path.repeats ? fineness.n_ramp_periods * path.duration() : 0},
        state_(relaxed_state(bed_, body, rising_.rest.indentation)),
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
    for (int period = 0; period < most_periods_of_path; ++period) {
      const SpringState start = state_;
      SpringHistory last = one_period(period);
      if (period < fineness_.n_ramp_periods) continue;
      const double scale = std::max(start.tangential_load.abs().maxCoeff(), mu_ * start.normal_load.maxCoeff());
      const double change = std::max((state_.tangential_load - start.tangential_load).abs().maxCoeff(),
                                     mu_ * (state_.normal_load - start.normal_load).abs().maxCoeff());
      const double allowed = body_.viscosity > 0 ? periodicity_with_dashpot : fineness_.periodicity;
      if (change <= allowed * scale) return {bed_, std::move(last)};
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
        const SpringState before = state_;
        steps_[piece].advance(state_, bed_,
                              rising_.at(piece, s, period * path_.duration() + time - path_.time.front()));
        see_step(result, before, duration / n_steps_[piece], margins);
        record(result, time, margins);
        result.indenter_work += work_of_last_step(result);
      }
    first_slip_.slip_path += margins.slip_path;
    finish(result, margins);
    result.last = state_;
    return result;
  }

  void see_step(SpringHistory& result, const SpringState& before, double dt, LeastMargins& margins) {
    const Eigen::ArrayXd slipped = state_.slip.abs();
    largest_shift_ = std::max(largest_shift_, std::abs(state_.indenter.tangential));
    margins.slip_path += (slipped > roundoff_of_step * largest_shift_).select(slipped, 0);
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
    result.normal_force.push_back(normal_force(bed_, body_, state_));
    result.tangential_force.push_back(tangential_force(bed_, body_, state_));
    result.axis_pressure.push_back(axis_pressure(axis_weights_, body_, state_));
  }

  static double work_of_last_step(const SpringHistory& result) {
    const std::size_t k = result.time.size() - 1;
    const auto trapezium = [k](const std::vector<double>& force, const std::vector<double>& way) {
      return (force[k - 1] + force[k]) / 2 * (way[k] - way[k - 1]);
    };
    return trapezium(result.normal_force, result.indentation) +
           trapezium(result.tangential_force, result.tangential_displacement);
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
};

PathForces forces_of(const SpringHistory& history) {
  const auto &time = history.time, &pull = history.tangential_force, &normal = history.normal_force;
  double largest = 0, mean = 0;
  for (std::size_t k = 0; k < pull.size(); ++k) {
    largest = std::max(largest, std::abs(pull[k]));
    if (k > 0) mean += (time[k] - time[k - 1]) * (pull[k - 1] + pull[k]) / 2;
  }
  return {*std::max_element(normal.begin(), normal.end()),
          *std::min_element(normal.begin(), normal.end()),
          *std::max_element(history.axis_pressure.begin(), history.axis_pressure.end()),
          largest,
          mean / (time.back() - time.front()),
          history.friction_work,
          history.bulk_work};
}

}  // namespace

PathCourse path_course(const Profile& profile, const PronyBody& body, double mu, const SampledPath& path,
                       const PathFineness& fineness) {
  validate(path);
  require_within("steps along a path", fineness.steps_per_duration, 1, 1e6);
  require_within("ramp periods", fineness.n_ramp_periods, 1, most_periods_of_path - 1);
  // No spring beyond: with a dashpot one that touches halfway would carry its jump of load over its whole width.
  const double outer = inverse_transform(profile, maximum_indentation(path));
  return Course(spring_bed(profile, outer, fineness.n_springs), body, mu, path, fineness).run();
}

SteppedPathForces path_forces(const Profile& profile, const PronyBody& body, double mu, const SampledPath& path,
                              const PathFineness& coarse) {
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
                          &PathForces::friction_work, &PathForces::bulk_work})
    extrapolate(part);
  return stepped;
}

}  // namespace fretval::mdr
