#include "fem/history/friction_history.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

#include "fem/history/cycle_jump.h"
#include "fem/history/friction_force.h"
#include "fem/history/running_minimum.h"
#include "fem/support/constants.h"
#include "fem/support/solver_error.h"

namespace fretval::fem {
namespace {

/// Carries the rings from step to step.
class FrictionStepper {
 public:
  FrictionStepper(const ContactProblem& problem, const RelaxationModel& relaxation, const Motion& motion, int n_steps)
      : problem_(problem),
        motion_([&motion](double t) { return tangential_motion(motion, t); }),
        dt_(2 * pi / n_steps),
        step_(relaxation, dt_),
        state_{Eigen::VectorXd::Zero(problem.n_rings()),
               Eigen::MatrixXd::Zero(problem.n_rings(), static_cast<Eigen::Index>(relaxation.moduli.size()))},
        stick_(static_cast<std::size_t>(problem.n_rings()), BoxState::interior),
        zones_(problem.n_rings()) {}

  struct Result {
    Eigen::VectorXd traction;  // at the balance time
    Eigen::VectorXd slip;      // in the whole step
  };

  Result compute_step(long index, const Eigen::VectorXd& limit) {
    const double begin = dt_ * static_cast<double>(index);
    const auto& areas = problem_.compliance.areas;
    const auto move = indenter_move(motion_, begin, begin + step_.fraction() * dt_);
    const Eigen::VectorXd held = step_.response_without_slip(state_, move);
    auto solution = problem_.solver.solve(areas.cwiseProduct(held), -limit, limit, stick_);
    zones_.update(limit, stick_, problem_.series.depths(solution.x));
    for (std::size_t i = 0; i < stick_.size(); ++i)
      if (limit[static_cast<Eigen::Index>(i)] == 0)
        stick_[i] = BoxState::interior;  // the guess for when it touches again
    Eigen::VectorXd slip = (solution.residual.array() / areas.array()).matrix() / step_.instantaneous();
    step_.advance(state_, indenter_move(motion_, begin, begin + dt_), slip);
    return {std::move(solution.x), std::move(slip)};
  }

  [[nodiscard]] RingState& state() { return state_; }
  [[nodiscard]] const Eigen::VectorXd& displacement() const { return state_.displacement; }
  [[nodiscard]] double fraction() const { return step_.fraction(); }
  /// The traction has kinks where these differ.
  [[nodiscard]] const SlipZones& zones() const { return zones_; }

 private:
  const ContactProblem& problem_;
  std::function<ValueAndRate(double)> motion_;
  double dt_;
  RelaxationStep step_;
  RingState state_;
  std::vector<BoxState> stick_;  // interior: sticks
  SlipZones zones_;
};

/// What is judged over one period.
struct Period {
  // Smallest mu p - tau and mu p + tau. Of the samples: between them a parabola would dip to zero at a kink.
  Eigen::VectorXd forward, backward;
  RunningMinimum forward_reserve, backward_reserve;  // slip reserves of the same
  Eigen::VectorXd slip;
  Eigen::MatrixXd traction;
  Eigen::VectorXd work, series_work;  // of friction, per area, and as a product of depths and displacements
  std::vector<signed char> zones;     // what happened to each ring, as bits

  Period(Eigen::Index n_rings, int n_steps)
      : forward(n_rings),
        backward(n_rings),
        forward_reserve(n_rings, -infinity),
        backward_reserve(n_rings, -infinity),
        slip(n_rings),
        traction(Eigen::MatrixXd::Zero(n_rings, n_steps)),
        work(n_rings),
        series_work(n_rings),
        zones(static_cast<std::size_t>(n_rings)) {}

  void begin() {
    for (auto* minimum : {&forward_reserve, &backward_reserve}) minimum->restart();
    forward.setConstant(infinity);
    backward.setConstant(infinity);
    slip.setZero();
    work.setZero();
    series_work.setZero();
    std::fill(zones.begin(), zones.end(), 0);
  }

  void add(int k, const Eigen::VectorXd& limit, const Eigen::VectorXd& limit_depths,
           const FrictionStepper::Result& step, const Eigen::VectorXd& depths) {
    forward = forward.cwiseMin(limit - step.traction);
    backward = backward.cwiseMin(limit + step.traction);
    forward_reserve.add(limit_depths - depths);
    backward_reserve.add(limit_depths + depths);
    slip += step.slip.cwiseAbs();
    traction.col(k) = step.traction;
    for (std::size_t i = 0; i < zones.size(); ++i) {
      const auto ring = static_cast<Eigen::Index>(i);
      if (step.slip[ring] != 0) zones[i] |= 1;
      zones[i] |= limit[ring] > 0 ? 2 : 4;
    }
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
  const int period_steps = normal.steps_per_cycle * motion.cycles_per_period();
  FrictionStepper stepper(problem, relaxation, motion, normal.steps_per_cycle);
  FrictionHistory history{};
  history.periodicity = infinity;
  history.slip_path = Eigen::VectorXd::Zero(n);
  history.first_slip_margin = Eigen::VectorXd::Constant(n, infinity);
  const auto& series = problem.series;
  const Eigen::MatrixXd depths_of_limits = friction_coefficient * series.depths(normal.pressure);
  Eigen::VectorXd traction = Eigen::VectorXd::Zero(n), traction_depths = traction;
  // No floor under a reserve: below zero between two samples it tells what a finer step would have let slip.
  RunningMinimum first_forward(n, -infinity), first_backward(n, -infinity);
  std::vector<double> force{0};
  TouchingRings touching{normal.touch_radii, relaxation.viscosity == 0};
  Period period(n, period_steps);
  const double creep = longest_creep_time(relaxation) / (2 * pi * motion.cycles_per_period());  // periods
  CycleJump jump(creep);
  bool jumped = false;
  while (jumped || !(history.periodicity <= control.periodicity)) {
    if (history.n_cycles >= control.max_cycles * motion.cycles_per_period())
      throw SolverError(fmt::format(
          "the tangential response is not periodic after {} cycles: it will still change by {:.1e} of its largest "
          "value, {:.1e} is asked for; the body creeps for {:.3g} cycles: leave out branches that are slow beyond "
          "interest, or raise the relaxed modulus",
          history.n_cycles, history.periodicity, control.periodicity, creep * motion.cycles_per_period()));
    const Eigen::MatrixXd before = period.traction;
    period.begin();
    for (int k = 0; k < period_steps; ++k) {
      const auto index = static_cast<long>(force.size()) - 1;
      const Eigen::Index column = normal.column(index + 1);
      const Eigen::VectorXd limit = friction_coefficient * normal.pressure.col(column);
      const auto step = stepper.compute_step(index, limit);
      const auto& depths = stepper.zones().depths();
      const Eigen::VectorXd limit_depths = depths_of_limits.col(column);
      history.first_slip_margin = history.first_slip_margin.cwiseMin(limit - step.traction.cwiseAbs());
      first_forward.add(limit_depths - depths);
      first_backward.add(limit_depths + depths);
      period.add(k, limit, limit_depths, step, depths);
      // The mean slip rate of a step belongs to its middle, between two balance times.
      const double weight = 1.5 - stepper.fraction();
      period.work += (weight * step.traction + (1 - weight) * traction).cwiseProduct(step.slip);
      period.series_work +=
          (weight * depths + (1 - weight) * traction_depths).cwiseProduct(series.displacements(step.slip));
      traction = step.traction;
      traction_depths = depths;
      touching.move_to(normal.contact_radius[column]);
      force.push_back(
          friction_force(series, stepper.zones(), touching, limit_depths, friction_coefficient * normal.force[column]));
    }
    history.n_cycles += motion.cycles_per_period();
    history.slip_path += period.slip;
    const bool after_jump = std::exchange(jumped, false);
    if (history.n_cycles <= std::max(motion.n_ramp_cycles, normal.n_cycles) + motion.cycles_per_period()) continue;
    if (!after_jump) history.periodicity = change_to_come(change_per_period(period.traction, before), creep);
    if (history.periodicity > control.periodicity) jumped = jump.advance(stepper.state());
  }
  history.shakedown_margin = (period.forward + period.backward) / 2;
  history.first_slip_reserve = first_forward.value().cwiseMin(first_backward.value());
  history.shakedown_reserve = (period.forward_reserve.value() + period.backward_reserve.value()) / 2;
  history.period_slip = period.slip;
  history.dissipated_energy = series.integral(period.series_work, period.zones);
  history.friction_work = period.work.cwiseProduct(problem.compliance.areas);
  history.traction = std::move(period.traction);
  history.displacement = stepper.displacement();
  history.force = Eigen::Map<Eigen::VectorXd>(force.data(), static_cast<Eigen::Index>(force.size()));
  return history;
}

}  // namespace fretval::fem
