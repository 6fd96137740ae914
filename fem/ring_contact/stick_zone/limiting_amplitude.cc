#include "fem/ring_contact/stick_zone/limiting_amplitude.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "fem/motion/running_minimum.h"
#include "fem/support/constants.h"

namespace fretval::fem {

using Eigen::Index;

namespace {

/// Response of a ring that sticks to the tangential motion at the balance times of a period.
std::vector<double> periodic_response(const RelaxationModel& relaxation, Motion motion, int steps_per_cycle) {
  motion.n_ramp_cycles = 0;
  const int n_steps = steps_per_cycle * motion.cycles_per_period();
  const double dt = 2 * pi / steps_per_cycle;
  const RelaxationStep step(relaxation, dt);
  const auto position = [&motion](double t) { return tangential_motion(motion, t); };
  const auto n_branches = static_cast<Index>(relaxation.moduli.size());
  RingState state{Eigen::VectorXd::Constant(1, position(0).value), Eigen::MatrixXd::Zero(1, n_branches)};
  std::vector<double> response;
  const auto go_through_period = [&] {
    response.clear();
    for (int k = 0; k < n_steps; ++k) {
      const double begin = k * dt;
      const auto to_balance = indenter_move(position, begin, begin + step.fraction() * dt);
      response.push_back(step.response_without_slip(state, to_balance)[0]);
      step.advance(state, indenter_move(position, begin, begin + dt), Eigen::VectorXd::Zero(1));
    }
  };
  // A period adds the same to a memory whatever it was at its start; the periodic memory decays by just that in a
  // period.
  go_through_period();
  for (Index i = 0; i < n_branches; ++i)
    state.memory(0, i) /= -std::expm1(-n_steps * dt / relaxation.times[static_cast<std::size_t>(i)]);
  state.displacement[0] = position(0).value;
  go_through_period();
  return response;
}

/// u(t) under a prescribed tangential force: the force over that of a unit punch of the n_inside innermost rings,
/// whatever the rheology.
std::vector<double> response_to_force(const PunchSeries& series, Motion motion, const NormalHistory& normal,
                                      Index n_inside) {
  motion.n_ramp_cycles = 0;
  std::vector<double> response;
  for (long k = 0; k < static_cast<long>(normal.steps_per_cycle) * motion.cycles_per_period(); ++k)
    response.push_back(tangential_motion(motion, normal.first_balance + 2 * pi * k / normal.steps_per_cycle).value /
                       series.punch_force(n_inside));
  return response;
}

/// Zero of a concave function that falls, by secants from two points beyond it, which approach it from there.
template <class Function>
double fallen_to_zero(const Function& f, double x, double next) {
  constexpr int most_iterations = 50;
  constexpr double roundoff = 1e-12;
  double value = f(x);
  for (int k = 0; k < most_iterations && std::abs(next - x) > roundoff * next; ++k) {
    const double before = std::exchange(value, f(next));
    if (value == before) break;
    const double change = value * (next - x) / (value - before);
    x = std::exchange(next, next - change);
  }
  return next;
}

}  // namespace

double limiting_amplitude(const ContactProblem& normal_problem, const ContactProblem& tangential_problem,
                          const RelaxationModel& relaxation, double friction_coefficient, const Motion& motion,
                          const NormalHistory& normal, Index n_inside) {
  const auto &pressed = normal_problem.series, &sheared = tangential_problem.series;
  const auto response = motion.tangential_force ? response_to_force(sheared, motion, normal, n_inside)
                                                : periodic_response(relaxation, motion, normal.steps_per_cycle);
  const double tangential_per_depth = friction_coefficient * pressed.force_per_radius() / sheared.force_per_radius();
  const Eigen::ArrayXXd grip =
      tangential_per_depth * pressed.depths_of_instants(normal.pressure).topRows(n_inside).array();
  const auto grip_at = [&](std::size_t step) { return grip.col(static_cast<Index>(step) % grip.cols()); };
  if (!(grip.minCoeff() > 0)) return 0;

  // A minimum counts once two more samples have come, so the period runs on into the next one.
  constexpr std::size_t run_on = 4;
  const auto reserve = [&](double factor) {
    RunningMinimum forward(n_inside, -infinity), backward(n_inside, -infinity);
    for (std::size_t k = 0; k < response.size() + run_on; ++k) {
      const std::size_t step = k % response.size();
      forward.add(grip_at(step) - factor * response[step]);
      backward.add(grip_at(step) + factor * response[step]);
    }
    return (forward.value() + backward.value()).minCoeff() / 2;
  };
  const auto [lowest, highest] = std::minmax_element(response.begin(), response.end());
  const Eigen::ArrayXd at_extremes = grip_at(static_cast<std::size_t>(highest - response.begin())) +
                                     grip_at(static_cast<std::size_t>(lowest - response.begin()));
  const double too_large = at_extremes.minCoeff() / (*highest - *lowest);
  return fallen_to_zero(reserve, 1.01 * too_large, too_large);
}

}  // namespace fretval::fem
