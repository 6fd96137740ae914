#include "mdr/springs/periodic_spring.h"

#include <Eigen/LU>
#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>

#include "mdr/support/checks.h"
#include "mdr/support/constants.h"

namespace fretval::mdr {

namespace {
constexpr int n_scan_steps = 16;  // from the deepest position to the angle of least harmonic force

// One cycle from theta = 0: how far the state ends from where it starts, and the derivative of that by the start. Both
// are of the order of 2 pi over the relaxation times and made up of terms of that size, so that slow branches keep
// their digits.
struct Cycle {
  PeriodicSpring spring;
  Eigen::VectorXd drift;
  Eigen::MatrixXd derivative;
};

double least_force_angle(const SpringModel& model) {
  return pi - std::atan2(model.loss, model.storage);
}

// Scanning with this step hits the angle of least harmonic force, so no loss of contact is too short to be seen.
double scan_step(const SpringModel& model) {
  return least_force_angle(model) / n_scan_steps;
}

/// Returns an expression, which allocates nothing.
auto decay(const SpringModel& model, double angle) {
  return (-angle / model.branch_times).exp();
}

double contact_force(const SpringModel& model, double y, const Eigen::ArrayXd& deviation, double since, double theta) {
  return harmonic_force(model, y, theta) - (model.branch_moduli * deviation * decay(model, theta - since)).sum();
}

template <class Function>
double root(const Function& function, double lower, double upper, double at_lower, double at_upper) {
  if (at_lower == 0) return lower;
  if (at_upper == 0) return upper;
  std::uintmax_t iterations = 100;
  const auto bracket = boost::math::tools::toms748_solve(function, lower, upper, at_lower, at_upper,
                                                         boost::math::tools::eps_tolerance<double>(50), iterations);
  return (bracket.first + bracket.second) / 2;
}

// First angle at which the contact force vanishes; 2 pi if it never does.
double find_lift_off(const SpringModel& model, double y, const Eigen::ArrayXd& deviation) {
  const auto force = [&](double theta) { return contact_force(model, y, deviation, 0, theta); };
  const double step = scan_step(model);
  double before = force(0);
  if (before <= 0) return 0;
  for (int k = 1; step * (k - 1) < 2 * pi; ++k) {
    const double theta = std::min(step * k, 2 * pi);
    const double now = force(theta);
    if (now < 0) return root(force, step * (k - 1), theta, before, now);
    before = now;
  }
  return 2 * pi;
}

// First angle after lift_off at which the indenter meets the free tip, whose modes start with the given amplitudes.
double find_touch_down(const SpringModel& model, double y, double lift_off, const Eigen::ArrayXd& amplitudes) {
  const Eigen::ArrayXd depths = model.recovery.depth_of_modes.transpose().array() * amplitudes;
  const auto gap = [&](double theta) {
    return (depths * (-model.recovery.rates * (theta - lift_off)).exp()).sum() - y - std::cos(theta);
  };
  const double step = scan_step(model);
  double lower = lift_off, upper = lift_off + step;
  while (upper < 2 * pi && gap(upper) > 0) {
    lower = upper;
    upper += step;
  }
  upper = std::min(upper, 2 * pi);
  double at_upper = gap(upper);
  if (at_upper > 0) return 2 * pi;
  // A loss of contact shorter than a step: the gap opens at lift-off and has closed again at the first sample.
  for (int halving = 0; lower == lift_off; ++halving) {
    if (halving == 50) return lift_off;
    const double middle = lift_off + (upper - lift_off) / 2;
    const double at_middle = gap(middle);
    (at_middle > 0 ? lower : upper) = middle;
    if (at_middle <= 0) at_upper = at_middle;
  }
  return root(gap, lower, upper, gap(lower), at_upper);
}

Eigen::VectorXd free_state(const SpringModel& model, double y, double lift_off, const Eigen::ArrayXd& deviation) {
  Eigen::VectorXd state(n_depth_states(model) + deviation.size());
  state.tail(deviation.size()) = harmonic_branch_depths(model, y, lift_off) + deviation;
  if (n_depth_states(model) == 1) state(0) = y + std::cos(lift_off);
  return state;
}

// Contact all the time; the two events are put where it would be lost first.
Cycle permanent_cycle(const SpringModel& model, double y, const Eigen::ArrayXd& initial) {
  const double event = least_force_angle(model);
  const Eigen::ArrayXd loss = (-2 * pi / model.branch_times).expm1();
  return {{y, event, event, initial, initial * decay(model, event)}, initial * loss, loss.matrix().asDiagonal()};
}

// Change of harmonic_branch_depths() between two angles, without the y that they share.
Eigen::ArrayXd harmonic_change(const SpringModel& model, double from, double to) {
  return harmonic_branch_depths(model, 0, to) - harmonic_branch_depths(model, 0, from);
}

Cycle run_cycle(const SpringModel& model, double y, const Eigen::ArrayXd& initial) {
  const Eigen::Index n_branches = initial.size();
  const double lift_off = find_lift_off(model, y, initial);
  const Eigen::ArrayXd to_lift_off = decay(model, lift_off);
  if (lift_off == 2 * pi) return permanent_cycle(model, y, initial);

  const FreeRecovery& recovery = model.recovery;
  const Eigen::ArrayXd amplitudes = recovery.to_modes * free_state(model, y, lift_off, initial * to_lift_off);
  const double touch_down = find_touch_down(model, y, lift_off, amplitudes);
  const Eigen::ArrayXd free_loss = (-recovery.rates * (touch_down - lift_off)).expm1();
  const auto branches = recovery.from_modes.bottomRows(n_branches);
  // While free, the branches move by themselves; in contact they would have followed the harmonic.
  const Eigen::ArrayXd departure =
      (branches * (free_loss * amplitudes).matrix()).array() - harmonic_change(model, lift_off, touch_down);

  const Eigen::ArrayXd to_end = decay(model, 2 * pi - touch_down);
  const Eigen::ArrayXd contact_loss = (-(2 * pi - touch_down + lift_off) / model.branch_times).expm1();
  Eigen::MatrixXd derivative = to_end.matrix().asDiagonal() *
                               (branches * free_loss.matrix().asDiagonal() * recovery.to_modes.rightCols(n_branches)) *
                               to_lift_off.matrix().asDiagonal();
  derivative.diagonal() += contact_loss.matrix();
  return {{y, lift_off, touch_down, initial, initial * to_lift_off + departure},
          (initial * contact_loss + departure * to_end).matrix(),
          std::move(derivative)};
}

}  // namespace

PeriodicSpring periodic_spring(const SpringModel& model, double y) {
  require_finite("relative rest depth of a spring", y);
  if (!(y > -1)) reject("relative rest depth of a spring", y, "must exceed -1, else the indenter never touches it");
  const Eigen::Index n_branches = model.branch_moduli.size();
  Eigen::ArrayXd deviation = Eigen::ArrayXd::Zero(n_branches);
  if (y >= std::hypot(model.storage, model.loss)) return permanent_cycle(model, y, deviation).spring;
  if (n_branches == 0) return run_cycle(model, y, deviation).spring;

  // Convergence is quadratic: after a step this small only roundoff is left.
  const double small_step = 1e-7 * (1 + std::abs(y));
  constexpr int n_newton_steps = 50;
  for (int k = 0; k < n_newton_steps; ++k) {
    const Cycle cycle = run_cycle(model, y, deviation);
    const Eigen::VectorXd step = -cycle.derivative.partialPivLu().solve(cycle.drift);
    deviation += step.array();
    if (step.cwiseAbs().maxCoeff() <= small_step) return run_cycle(model, y, deviation).spring;
  }
  throw std::runtime_error("spring at the relative rest depth y = " + std::to_string(y) + " is not periodic after " +
                           std::to_string(n_newton_steps) + " Newton steps");
}

double spring_force(const SpringModel& model, const PeriodicSpring& spring, double theta) {
  if (theta <= spring.lift_off) return contact_force(model, spring.y, spring.initial_deviation, 0, theta);
  if (theta < spring.touch_down) return 0;
  return contact_force(model, spring.y, spring.touch_down_deviation, spring.touch_down, theta);
}

double contact_margin(const PeriodicSpring& spring, double theta) {
  return std::max(spring.lift_off - theta, theta - spring.touch_down);
}

}  // namespace fretval::mdr
