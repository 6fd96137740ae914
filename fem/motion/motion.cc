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

/// With how many equal parts of a cycle they repeat.
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

/// Lags of the tangential motion that differ.
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

/// Their sum at a time that runs at the given rate.
ValueAndRate sum_of(const std::vector<Oscillation>& oscillations, const ValueAndRate& time) {
  ValueAndRate sum{0, 0};
  for (const auto& [amplitude, order, phase] : oscillations) {
    const double argument = order * time.value + phase;
    sum.value += amplitude * std::cos(argument);
    sum.rate -= amplitude * order * time.rate * std::sin(argument);
  }
  return sum;
}

ValueAndRate product(const ValueAndRate& e, const ValueAndRate& f) {
  return {e.value * f.value, e.rate * f.value + e.value * f.rate};
}

/// From rest, of a path at any time of a history.
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
    for (const double u : path->tangential) sum = std::max(sum, std::abs(u - path->rest_tangential));
  return sum;
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

double tangential_path(const Motion& motion) {
  double path = 0;
  for (const auto& oscillation : motion.tangential) path += 4 * oscillation.amplitude * oscillation.order;
  if (motion.path)
    for (std::size_t k = 1; k < motion.path->tangential.size(); ++k)
      path += std::abs(motion.path->tangential[k] - motion.path->tangential[k - 1]);
  return path;
}

StepTimes::StepTimes(const Motion& motion, int steps_per_cycle) : dt_(2 * pi / steps_per_cycle) {
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
