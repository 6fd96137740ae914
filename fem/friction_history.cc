#include "fem/friction_history.h"

#include <fmt/format.h>

#include <functional>
#include <limits>
#include <vector>

#include "fem/edge.h"
#include "fem/running_minimum.h"
#include "fem/solver_error.h"

namespace fretval::fem {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Carries the rings from step to step.
class Stepper {
 public:
  Stepper(const ContactProblem& problem, const RelaxationModel& relaxation, const Motion& motion, int n_steps)
      : problem_(problem),
        motion_([&motion](double t) { return tangential_motion(motion, t); }),
        dt_(2 * pi / n_steps),
        step_(relaxation, dt_),
        state_{Eigen::VectorXd::Zero(problem.n_rings()),
               Eigen::MatrixXd::Zero(problem.n_rings(), static_cast<Eigen::Index>(relaxation.moduli.size()))},
        traction_(Eigen::VectorXd::Zero(problem.n_rings())),
        stick_(static_cast<std::size_t>(problem.n_rings()), BoxState::interior) {}

  struct Result {
    Eigen::VectorXd traction;         // at the balance time
    Eigen::VectorXd slip;             // in the whole step
    Eigen::VectorXd middle_traction;  // at the middle of the step, where the mean slip rate belongs
  };

  Result compute_step(long index, const Eigen::VectorXd& limit) {
    const double begin = dt_ * static_cast<double>(index);
    const auto& areas = problem_.compliance.areas;
    const auto move = indenter_move(motion_, begin, begin + step_.fraction() * dt_);
    const Eigen::VectorXd held = step_.response_without_slip(state_, move);
    auto solution = problem_.solver.solve(areas.cwiseProduct(held), -limit, limit, stick_);
    for (std::size_t i = 0; i < stick_.size(); ++i)
      if (limit[static_cast<Eigen::Index>(i)] == 0)
        stick_[i] = BoxState::interior;  // the guess for when it touches again
    Eigen::VectorXd slip = (solution.residual.array() / areas.array()).matrix() / step_.instantaneous();
    step_.advance(state_, indenter_move(motion_, begin, begin + dt_), slip);
    const double weight = 1.5 - step_.fraction();  // of the balance time, between it and the one before
    Eigen::VectorXd middle_traction = weight * solution.x + (1 - weight) * traction_;
    traction_ = solution.x;
    return {std::move(solution.x), std::move(slip), std::move(middle_traction)};
  }

  [[nodiscard]] const Eigen::VectorXd& displacement() const { return state_.displacement; }

 private:
  const ContactProblem& problem_;
  std::function<ValueAndRate(double)> motion_;
  double dt_;
  RelaxationStep step_;
  RingState state_;
  Eigen::VectorXd traction_;     // at the last balance time
  std::vector<BoxState> stick_;  // interior: sticks
};

/// Slip reserves at an instant, against slip in either direction.
struct Reserves {
  Eigen::VectorXd forward, backward;
};

/// What is judged over one period.
struct Period {
  RunningMinimum forward, backward;                  // mu p - tau, mu p + tau
  RunningMinimum forward_reserve, backward_reserve;  // slip reserves of the same
  Eigen::VectorXd slip;
  Eigen::MatrixXd traction;
  double dissipated_energy = 0;

  Period(Eigen::Index n_rings, int n_steps)
      : forward(n_rings, 0),
        backward(n_rings, 0),
        forward_reserve(n_rings, -infinity),
        backward_reserve(n_rings, -infinity),
        slip(n_rings),
        traction(Eigen::MatrixXd::Zero(n_rings, n_steps)) {}

  void begin() {
    for (auto* minimum : {&forward, &backward, &forward_reserve, &backward_reserve}) minimum->restart();
    slip.setZero();
    dissipated_energy = 0;
  }

  void add(int k, const Eigen::VectorXd& limit, const Stepper::Result& step, const Reserves& reserves,
           const Eigen::VectorXd& areas) {
    forward.add(limit - step.traction);
    backward.add(limit + step.traction);
    forward_reserve.add(reserves.forward);
    backward_reserve.add(reserves.backward);
    slip += step.slip.cwiseAbs();
    traction.col(k) = step.traction;
    dissipated_energy += (step.middle_traction.array() * step.slip.array() * areas.array()).sum();
  }
};

double change_per_period(const Eigen::MatrixXd& now, const Eigen::MatrixXd& before) {
  const double largest = now.cwiseAbs().maxCoeff();
  return largest == 0 ? 0 : (now - before).cwiseAbs().maxCoeff() / largest;
}

}  // namespace

FrictionHistory friction_history(const ContactProblem& problem, const RelaxationModel& relaxation,
                                 double friction_coefficient, const Motion& motion, const NormalHistory& normal,
                                 const HistoryControl& control) {
  const Eigen::Index n = problem.n_rings();
  const auto& areas = problem.compliance.areas;
  const int period_steps = normal.steps_per_cycle * motion.cycles_per_period();
  Stepper stepper(problem, relaxation, motion, normal.steps_per_cycle);
  FrictionHistory history{};
  history.periodicity = infinity;
  history.slip_path = Eigen::VectorXd::Zero(n);
  const SlipReserve reserve(problem);
  // No floor under a reserve: below zero between two samples it tells what a finer step would have let slip.
  RunningMinimum first_slip(n, 0), first_forward(n, -infinity), first_backward(n, -infinity);
  std::vector<double> force{0};
  Period period(n, period_steps);
  while (!(history.periodicity <= control.periodicity)) {
    if (history.n_cycles >= control.max_cycles * motion.cycles_per_period())
      throw SolverError(
          fmt::format("the tangential response is not periodic after {} cycles: it still changes by {:.1e} "
                      "of its largest value per period, {:.1e} is asked for",
                      history.n_cycles, history.periodicity, control.periodicity));
    const Eigen::MatrixXd before = period.traction;
    period.begin();
    for (int k = 0; k < period_steps; ++k) {
      const auto index = static_cast<long>(force.size()) - 1;
      const Eigen::VectorXd limit = friction_coefficient * normal.pressure.col(normal.column(index + 1));
      const auto step = stepper.compute_step(index, limit);
      const Reserves reserves{reserve.of(limit - step.traction), reserve.of(limit + step.traction)};
      first_slip.add(limit - step.traction.cwiseAbs());
      first_forward.add(reserves.forward);
      first_backward.add(reserves.backward);
      period.add(k, limit, step, reserves, areas);
      force.push_back(step.traction.dot(areas));
    }
    history.n_cycles += motion.cycles_per_period();
    history.slip_path += period.slip;
    if (history.n_cycles > motion.n_ramp_cycles + motion.cycles_per_period())
      history.periodicity = change_per_period(period.traction, before);
  }
  history.first_slip_margin = first_slip.value();
  history.shakedown_margin = (period.forward.value() + period.backward.value()) / 2;
  history.first_slip_reserve = first_forward.value().cwiseMin(first_backward.value());
  history.shakedown_reserve = (period.forward_reserve.value() + period.backward_reserve.value()) / 2;
  history.period_slip = period.slip;
  history.dissipated_energy = period.dissipated_energy;
  history.traction = std::move(period.traction);
  history.displacement = stepper.displacement();
  history.force = Eigen::Map<Eigen::VectorXd>(force.data(), static_cast<Eigen::Index>(force.size()));
  return history;
}

}  // namespace fretval::fem
