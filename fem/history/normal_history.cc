#include "fem/history/normal_history.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "fem/history/contact_force.h"
#include "fem/history/cycle_jump.h"
#include "fem/history/require_room.h"
#include "fem/history/running_minimum.h"
#include "fem/support/constants.h"
#include "fem/support/solver_error.h"

namespace fretval::fem {
namespace {

NormalContact solve_contact(const ContactProblem& problem, const Eigen::VectorXd& target,
                            std::vector<BoxState>& contact) {
  const Eigen::Index n = problem.n_rings();
  const auto& areas = problem.compliance.areas;
  const auto solution = problem.solver.solve(areas.cwiseProduct(target), Eigen::VectorXd::Zero(n),
                                             Eigen::VectorXd::Constant(n, infinity), contact);
  return {solution.x, (-solution.residual.array() / areas.array()).matrix()};
}

double change_per_cycle(const std::vector<Eigen::VectorXd>& pressure, int n_steps) {
  double change = 0, largest = 0;
  for (std::size_t k = pressure.size() - static_cast<std::size_t>(n_steps); k < pressure.size(); ++k) {
    change = std::max(change, (pressure[k] - pressure[k - static_cast<std::size_t>(n_steps)]).cwiseAbs().maxCoeff());
    largest = std::max(largest, pressure[k].maxCoeff());
  }
  return change > 0 ? change / largest : 0;
}

PressureAtEdge pressure_at_edge(const RelaxationModel& relaxation) {
  if (relaxation.viscosity == 0) return PressureAtEdge::vanishes;
  return relaxation.moduli.empty() ? PressureAtEdge::jumps : PressureAtEdge::falls_and_jumps;
}

/// Carries the rings from step to step.
class NormalStepper {
 public:
  NormalStepper(const ContactProblem& problem, const RelaxationModel& relaxation, const Eigen::VectorXd& profile,
                const Motion& motion, int n_steps)
      : problem_(problem),
        relaxed_(relaxation.relaxed),
        edge_(pressure_at_edge(relaxation)),
        profile_(profile),
        motion_([&motion](double t) { return normal_motion(motion, t); }),
        n_steps_(n_steps),
        step_(relaxation, 2 * pi / n_steps),
        state_{{}, Eigen::MatrixXd::Zero(profile.size(), static_cast<Eigen::Index>(relaxation.moduli.size()))},
        contact_(static_cast<std::size_t>(profile.size()), BoxState::lower),
        gap_at_balance_(profile.size(), 0) {}

  /// Relaxed contact at the mean indentation; returns its ring pressures.
  Eigen::VectorXd start() {
    const double indentation = motion_(0).value;
    const auto contact = normal_contact(problem_, profile_, indentation);
    state_.displacement = (indentation - profile_.array() + contact.gap.array()).matrix();
    for (Eigen::Index i = 0; i < profile_.size(); ++i)
      if (contact.pressure[i] > 0) contact_[static_cast<std::size_t>(i)] = BoxState::interior;
    auto reading = contact_force(problem_.series, contact.pressure, contact.gap);
    reading.force *= relaxed_;
    remember(reading);
    return relaxed_ * contact.pressure;
  }

  [[nodiscard]] RingState& state() { return state_; }

  /// At every instant so far.
  [[nodiscard]] const std::vector<ContactForce>& contact_forces() const { return contact_forces_; }

  void compute_cycle(NormalHistory& history, std::vector<Eigen::VectorXd>& pressure, std::vector<double>& time) {
    history.smallest_gap = Eigen::VectorXd::Constant(profile_.size(), infinity);
    gap_at_balance_.restart();
    double deepest = -infinity, highest = infinity;
    const double dt = 2 * pi / n_steps_;
    for (int k = 0; k < n_steps_; ++k) {
      const double begin = dt * static_cast<double>(time.size() - 1), balance = begin + step_.fraction() * dt;
      pressure.push_back(compute_step(begin, balance, begin + dt));
      time.push_back(balance);
      require_room(pressure.back());
      history.smallest_gap = history.smallest_gap.cwiseMin(gap_);
      const double indentation = motion_(begin + dt).value;
      if (indentation > deepest) history.deepest_displacement = state_.displacement;
      if (indentation < highest) history.highest_displacement = state_.displacement;
      deepest = std::max(deepest, indentation);
      highest = std::min(highest, indentation);
    }
    history.smallest_gap_at_balance =
        (history.smallest_gap.array() > 0).select(gap_at_balance_.value(), history.smallest_gap);
  }

 private:
  /// Rings that are in contact at the beginning of a step, if a dashpot makes that matter.
  [[nodiscard]] std::optional<Eigen::Index> n_closed() const {
    constexpr double hardly_viscous = 0.99, roundoff = 1e-12;
    if (step_.fraction() > hardly_viscous) return std::nullopt;
    return (gap_.array() <= roundoff * gap_.maxCoeff()).count();
  }

  void remember(const ContactForce& contact) {
    contact_forces_.push_back(contact);
    largest_radius_ = std::max(largest_radius_, contact.radius);
  }

  Eigen::VectorXd compute_step(double begin, double balance, double end) {
    gap_ = state_.displacement + profile_;
    gap_.array() -= motion_(begin).value;
    // A ring in contact closes its gap: it slips by what is left of it.
    const Eigen::VectorXd held = step_.response_without_slip(state_, indenter_move(motion_, begin, balance));
    auto contact = solve_contact(problem_, held - step_.instantaneous() * gap_, contact_);
    const Eigen::VectorXd new_gap = contact.gap / step_.instantaneous();
    const double weight = step_.fraction();
    step_.advance(state_, indenter_move(motion_, begin, end), gap_ - new_gap);
    const Eigen::VectorXd gap = weight * new_gap + (1 - weight) * gap_;
    gap_at_balance_.add(gap);
    remember(contact_force(problem_.series, contact.pressure, gap, {largest_radius_, n_closed(), edge_}));
    gap_ = new_gap;
    return std::move(contact.pressure);
  }

  const ContactProblem& problem_;
  double relaxed_;
  PressureAtEdge edge_;
  const Eigen::VectorXd& profile_;
  std::function<ValueAndRate(double)> motion_;
  int n_steps_;
  RelaxationStep step_;
  RingState state_;
  std::vector<BoxState> contact_;
  Eigen::VectorXd gap_;  // at the end of the step
  RunningMinimum gap_at_balance_;
  double largest_radius_ = 0;  // of the contact, so far
  std::vector<ContactForce> contact_forces_;
};

}  // namespace

Eigen::Index NormalHistory::column(long step) const {
  const long last = static_cast<long>(n_cycles) * steps_per_cycle;
  if (step <= last) return step;
  return last - steps_per_cycle + 1 + (step - last - 1) % steps_per_cycle;
}

Eigen::VectorXd ring_means(const Compliance& compliance, const std::function<double(double)>& f) {
  // 5-point Gauss: exact for polynomials of degree 8 times r; profiles are smooth inside a ring.
  constexpr std::array<double, 5> points{-0.9061798459386640, -0.5384693101056831, 0, 0.5384693101056831,
                                         0.9061798459386640};
  constexpr std::array<double, 5> weights{0.2369268850561891, 0.4786286704993665, 0.5688888888888889,
                                          0.4786286704993665, 0.2369268850561891};
  Eigen::VectorXd means(compliance.areas.size());
  for (Eigen::Index i = 0; i < means.size(); ++i) {
    const double inner = compliance.radii[i], outer = compliance.radii[i + 1];
    double sum = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
      const double r = (inner + outer) / 2 + points[k] * (outer - inner) / 2;
      sum += weights[k] * r * f(r);
    }
    means[i] = sum / (inner + outer);
  }
  return means;
}

NormalContact normal_contact(const ContactProblem& problem, const Eigen::VectorXd& profile, double indentation) {
  std::vector<BoxState> contact(static_cast<std::size_t>(problem.n_rings()), BoxState::lower);
  for (Eigen::Index i = 0; i < profile.size(); ++i)
    if (profile[i] < indentation) contact[i] = BoxState::interior;
  return solve_contact(problem, (indentation - profile.array()).matrix(), contact);
}

NormalHistory normal_history(const ContactProblem& problem, const RelaxationModel& relaxation,
                             const Eigen::VectorXd& profile, const Motion& motion, const HistoryControl& control) {
  NormalStepper stepper(problem, relaxation, profile, motion, control.steps_per_cycle);
  const int n_steps = control.steps_per_cycle;
  NormalHistory history;
  history.steps_per_cycle = n_steps;
  history.periodicity = infinity;
  std::vector<Eigen::VectorXd> pressure{stepper.start()};
  std::vector<double> time{0};
  const double creep = longest_creep_time(relaxation) / (2 * pi);
  CycleJump jump(creep);
  bool jumped = false;
  while (jumped || !(history.periodicity <= control.periodicity)) {
    if (history.n_cycles >= control.max_cycles)
      throw SolverError(fmt::format(
          "the normal response is not periodic after {} cycles: it will still change by {:.1e} of its largest value, "
          "{:.1e} is asked for; the body creeps for {:.3g} cycles: leave out branches that are "
          "slow beyond interest, or raise the relaxed modulus",
          history.n_cycles, history.periodicity, control.periodicity, creep));
    stepper.compute_cycle(history, pressure, time);
    ++history.n_cycles;
    const bool after_jump = std::exchange(jumped, false);
    if (history.n_cycles <= std::max(motion.n_ramp_cycles, 1)) continue;
    if (!after_jump) history.periodicity = change_to_come(change_per_cycle(pressure, n_steps), creep);
    if (history.periodicity > control.periodicity) jumped = jump.advance(stepper.state());
  }
  const auto n = static_cast<Eigen::Index>(pressure.size());
  history.time = Eigen::Map<Eigen::VectorXd>(time.data(), n);
  history.pressure.resize(problem.n_rings(), n);
  for (auto* series : {&history.indentation, &history.force, &history.force_uncertainty, &history.kink_uncertainty,
                       &history.contact_radius})
    series->resize(n);
  history.n_closed.resize(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    history.pressure.col(k) = pressure[static_cast<std::size_t>(k)];
    history.indentation[k] = normal_motion(motion, history.time[k]).value;
    const auto& contact = stepper.contact_forces()[static_cast<std::size_t>(k)];
    history.force[k] = contact.force;
    history.force_uncertainty[k] = contact.uncertainty;
    history.kink_uncertainty[k] = contact.kink_uncertainty;
    history.n_closed[k] = contact.n_closed;
    history.contact_radius[k] = contact.radius;
  }
  history.touch_radii = problem.series.radii();
  return history;
}

}  // namespace fretval::fem
