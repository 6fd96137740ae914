#include "fem/motion/motion.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "fem/support/constants.h"

namespace fretval::fem {
namespace {

int highest(const std::vector<Oscillation>& oscillations) {
  int order = 1;
  for (const auto& oscillation : oscillations) order = std::max(order, oscillation.order);
  return order;
}

/// Number of equal parts of a cycle with which oscillations repeat.
int common_divisor(const std::vector<Oscillation>& oscillations) {
  int divisor = 0;
  for (const auto& oscillation : oscillations) divisor = std::gcd(divisor, oscillation.order);
  return divisor;
}

double ramp_duration(const Motion& motion) {
  int lowest = motion.highest_order();
  for (const auto* direction : {&motion.normal, &motion.tangential})
    for (const auto& oscillation : *direction) lowest = std::min(lowest, oscillation.order);
  return 2 * pi * motion.n_ramp_cycles / lowest;
}

// Quintic smooth step: value, slope and curvature are continuous at both ends.
ValueAndRate envelope(const Motion& motion, double t) {
  if (t >= 2 * pi * motion.n_ramp_cycles || motion.is_single_pass()) return {1, 0};
  const double duration = ramp_duration(motion);
  if (t >= duration) return {1, 0};
  const double x = t / duration;
  return {x * x * x * (10 + x * (-15 + 6 * x)), 30 * x * x * (1 - x) * (1 - x) / duration};
}

/// Range of the lags of the tangential motion that differ.
double span_of_lags(const Motion& motion) {
  const int normal = common_divisor(motion.normal), tangential = common_divisor(motion.tangential);
  const bool turns_round =
      motion.normal.size() == 1 && motion.tangential.size() == 1 && normal == tangential && !motion.has_forces();
  return (turns_round ? pi : 2 * pi) / std::lcm(std::max(normal, 1), std::max(tangential, 1));
}

ValueAndRate lag(const Motion& motion, double t) {
  if (motion.locked) return {0, 0};
  const double n = motion.cycles_per_period(), x = t / n, half = span_of_lags(motion) / 2;
  return {half * (1 - std::cos(x)), half * std::sin(x) / n};
}

/// Sum of the oscillations along x or across, at a time that runs at the given rate.
ValueAndRate sum_of(const std::vector<Oscillation>& oscillations, const ValueAndRate& time, bool across = false) {
  ValueAndRate sum{0, 0};
  for (const auto& [amplitude, order, phase, goes_across] : oscillations) {
    if (goes_across != across) continue;
    const double argument = order * time.value + phase;
    sum.value += amplitude * std::cos(argument);
    sum.rate -= amplitude * order * time.rate * std::sin(argument);
  }
  return sum;
}

ValueAndRate product(const ValueAndRate& e, const ValueAndRate& f) {
  return {e.value * f.value, e.rate * f.value + e.value * f.rate};
}

/// Departure of a path from rest, and its rate, at any time of a history.
ValueAndRate departure(const SampledPath& path, const std::vector<double>& values, double rest, double t,
                       double inside) {
  const double cycle = path.repeats ? 2 * pi * std::floor(inside / (2 * pi)) : 0;
  auto value = along(path, values, t - cycle, inside - cycle);
  value.value -= rest;
  return value;
}

}  // namespace

int Motion::cycles_per_period() const {
  return locked ? 1 : creep_period(n_creep_cycles, highest_order());
}

int Motion::highest_order() const {
  return std::max(highest(normal), highest(tangential));
}

int Motion::highest_normal_order() const {
  return highest(normal);
}

int Motion::cycles_of_ramp() const {
  return is_single_pass() ? 0 : static_cast<int>(std::ceil(ramp_duration(*this) / (2 * pi)));
}

double Motion::tangential_amplitude() const {
  double sum = 0;
  for (const auto& oscillation : tangential) sum += oscillation.amplitude;
  if (path)
    for (std::size_t k = 0; k < path->tangential.size(); ++k)
      sum = std::max(sum, std::hypot(path->tangential[k] - path->rest_tangential,
                                     path->moves_across() ? path->transverse[k] - path->rest_transverse : 0));
  return sum;
}

bool Motion::moves_across() const {
  if (path) return path->moves_across();
  return std::any_of(tangential.begin(), tangential.end(), [](const Oscillation& o) { return o.across; });
}

int creep_period(int n_creep_cycles, int highest_order) {
  constexpr int largest_divisor = 2;
  const int divisor = std::min(highest_order, largest_divisor);
  return (n_creep_cycles + divisor - 1) / divisor;
}

Motion one_frequency(double indentation, double normal_amplitude, double tangential_amplitude,
                     std::optional<double> phase) {
  return {indentation, {{normal_amplitude}}, {{tangential_amplitude, 1, phase.value_or(0)}}, phase.has_value()};
}

double amplitude_share(const Motion& motion, double t) {
  return envelope(motion, t).value;
}

ValueAndRate normal_motion(const Motion& motion, double t) {
  return normal_motion_inside(motion, t, t);
}

ValueAndRate tangential_motion(const Motion& motion, double t) {
  return tangential_motion_inside(motion, t, t);
}

ValueAndRate normal_motion_inside(const Motion& motion, double t, double inside_step) {
  if (motion.path) {
    const auto& path = *motion.path;
    auto d = product(envelope(motion, t), departure(path, path.normal, path.rest_normal, t, inside_step));
    d.value += path.rest_normal;
    return d;
  }
  auto d = product(envelope(motion, t), sum_of(motion.normal, {t, 1}));
  d.value += motion.indentation;
  return d;
}

ValueAndRate tangential_motion_inside(const Motion& motion, double t, double inside_step) {
  if (motion.path) {
    const auto& path = *motion.path;
    return product(envelope(motion, t), departure(path, path.tangential, path.rest_tangential, t, inside_step));
  }
  const auto s = lag(motion, t);
  return product(envelope(motion, t), sum_of(motion.tangential, {t + s.value, 1 + s.rate}));
}

ValueAndRate transverse_motion(const Motion& motion, double t) {
  return transverse_motion_inside(motion, t, t);
}

ValueAndRate transverse_motion_inside(const Motion& motion, double t, double inside_step) {
  if (!motion.moves_across()) return {0, 0};
  if (motion.path) {
    const auto& path = *motion.path;
    return product(envelope(motion, t), departure(path, path.transverse, path.rest_transverse, t, inside_step));
  }
  const auto s = lag(motion, t);
  return product(envelope(motion, t), sum_of(motion.tangential, {t + s.value, 1 + s.rate}, true));
}

double tangential_path(const Motion& motion) {
  double path = 0;
  if (motion.moves_across() && !motion.path) {
    const int n = 256 * motion.highest_order();
    for (int k = 0; k < n; ++k) {
      const ValueAndRate time{2 * pi * k / n, 1};
      path += std::hypot(sum_of(motion.tangential, time).rate, sum_of(motion.tangential, time, true).rate);
    }
    return path * 2 * pi / n;
  }
  for (const auto& oscillation : motion.tangential) path += 4 * oscillation.amplitude * oscillation.order;
  if (motion.path)
    for (std::size_t k = 1; k < motion.path->tangential.size(); ++k)
      path += std::hypot(motion.path->tangential[k] - motion.path->tangential[k - 1],
                         motion.path->moves_across() ? motion.path->transverse[k] - motion.path->transverse[k - 1] : 0);
  return path;
}

StepTimes::StepTimes(int steps_per_cycle) : steps_per_cycle_(steps_per_cycle), dt_(2 * pi / steps_per_cycle) {}

StepTimes::StepTimes(const Motion& motion, int steps_per_cycle) : StepTimes(steps_per_cycle) {
  if (motion.path) steps_ = steps_of(*motion.path, steps_per_cycle);
}

double StepTimes::begin(long step) const {
  if (steps_.empty()) return dt_ * static_cast<double>(step);
  const auto n = static_cast<long>(steps_.size());
  return 2 * pi * static_cast<double>(step / n) + steps_[static_cast<std::size_t>(step % n)].begin;
}

std::optional<StepInPiece> StepTimes::in_piece(long step) const {
  if (steps_.empty()) return {};
  return steps_[static_cast<std::size_t>(step % static_cast<long>(steps_.size()))];
}

}  // namespace fretval::fem
