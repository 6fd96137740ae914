#include "fem/friction_history.h"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "fem/running_minimum.h"
#include "fem/solver_error.h"

namespace fretval::fem {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Everything that is carried from one step to the next.
struct State {
  Eigen::VectorXd displacement;
  Eigen::MatrixXd memory;
  std::vector<BoxState> stick;  // interior: sticks
};

struct StepResult {
  Eigen::VectorXd traction, slip;
};

StepResult friction_step(const ContactProblem& problem, const RelaxationStep& step, const Eigen::VectorXd& limit,
                         double increment, const StepRates& rates, State& state) {
  const auto& areas = problem.compliance.areas;
  const Eigen::VectorXd held = step.response_without_slip(state.displacement, state.memory, increment, rates);
  auto solution = problem.solver.solve(areas.cwiseProduct(held), -limit, limit, state.stick);
  for (std::size_t i = 0; i < state.stick.size(); ++i)
    if (limit[static_cast<Eigen::Index>(i)] == 0) state.stick[i] = BoxState::interior;  // sticks when it touches again
  Eigen::VectorXd slip = (solution.residual.array() / areas.array()).matrix() / step.instantaneous();
  step.advance(state.displacement, state.memory, increment, rates, slip);
  return {std::move(solution.x), std::move(slip)};
}

}  // namespace

FrictionHistory friction_history(const ContactProblem& problem, const RelaxationModel& relaxation,
                                 double friction_coefficient, const Motion& motion, const NormalHistory& normal,
                                 const HistoryControl& control) {
  const int n_steps = normal.steps_per_cycle;
  const int period_steps = n_steps * motion.cycles_per_period();
  const double dt = 2 * pi / n_steps;
  const RelaxationStep step(relaxation, dt);
  const auto& areas = problem.compliance.areas;
  const Eigen::Index n = problem.n_rings();

  State state{Eigen::VectorXd::Zero(n), Eigen::MatrixXd::Zero(n, static_cast<Eigen::Index>(relaxation.moduli.size())),
              std::vector<BoxState>(static_cast<std::size_t>(n), BoxState::interior)};
  FrictionHistory history{};
  history.periodicity = infinity;
  history.slip_path = Eigen::VectorXd::Zero(n);
  RunningMinimum first_slip(n);
  std::vector<double> displacement{0}, force{0};
  auto now = tangential_motion(motion, 0);
  Eigen::MatrixXd traction(n, period_steps), before(n, period_steps);
  while (!(history.periodicity <= control.periodicity)) {
    if (history.n_cycles >= control.max_cycles * motion.cycles_per_period())
      throw SolverError("the tangential response is not periodic after " + std::to_string(history.n_cycles) +
                        " cycles: it still changes by " + std::to_string(history.periodicity) +
                        " of its largest value per period");
    before.swap(traction);
    RunningMinimum forward(n), backward(n);
    history.period_slip = Eigen::VectorXd::Zero(n);
    history.dissipated_energy = 0;
    const long first = static_cast<long>(history.n_cycles) * n_steps;
    for (int k = 1; k <= period_steps; ++k) {
      const double t = dt * static_cast<double>(first + k);
      const auto next = tangential_motion(motion, t);
      const StepRates rates{now.rate, tangential_motion(motion, t - dt / 2).rate, next.rate};
      const Eigen::VectorXd limit = friction_coefficient * normal.pressure.col(normal.column(first + k));
      const auto [tau, slip] = friction_step(problem, step, limit, next.value - now.value, rates, state);
      traction.col(k - 1) = tau;
      first_slip.add(limit - tau.cwiseAbs());
      forward.add(limit - tau);
      backward.add(limit + tau);
      history.period_slip += slip.cwiseAbs();
      history.dissipated_energy += (tau.array() * slip.array() * areas.array()).sum();
      displacement.push_back(next.value);
      force.push_back(tau.dot(areas));
      now = next;
    }
    history.n_cycles += motion.cycles_per_period();
    history.slip_path += history.period_slip;
    history.shakedown_margin = (forward.value() + backward.value()) / 2;
    const double largest = std::max(traction.cwiseAbs().maxCoeff(), std::numeric_limits<double>::min());
    if (history.n_cycles > motion.n_ramp_cycles + motion.cycles_per_period())
      history.periodicity = (traction - before).cwiseAbs().maxCoeff() / largest;
  }
  history.first_slip_margin = first_slip.value();
  history.displacement = Eigen::Map<Eigen::VectorXd>(displacement.data(), static_cast<Eigen::Index>(displacement.size()));
  history.force = Eigen::Map<Eigen::VectorXd>(force.data(), static_cast<Eigen::Index>(force.size()));
  history.traction = std::move(traction);
  return history;
}

}  // namespace fretval::fem
