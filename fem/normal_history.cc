#include "fem/normal_history.h"

#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "fem/solver_error.h"

namespace fretval::fem {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double infinity = std::numeric_limits<double>::infinity();

struct State {
  Eigen::VectorXd displacement;
  Eigen::MatrixXd memory;
  std::vector<BoxState> contact;
};

void require_room(const Eigen::VectorXd& pressure) {
  if (pressure[pressure.size() - 1] > 0)
    throw SolverError("the contact reaches the end of the contact line of the mesh: use a longer one");
}

NormalContact solve_contact(const ContactProblem& problem, const Eigen::VectorXd& target, std::vector<BoxState>& contact) {
  const Eigen::Index n = problem.n_rings();
  const auto& areas = problem.compliance.areas;
  const auto solution = problem.solver.solve(areas.cwiseProduct(target), Eigen::VectorXd::Zero(n),
                                             Eigen::VectorXd::Constant(n, infinity), contact);
  return {solution.x, (-solution.residual.array() / areas.array()).matrix()};
}

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
  const int n_steps = control.steps_per_cycle;
  const double dt = 2 * pi / n_steps;
  const RelaxationStep step(relaxation, dt);
  const Eigen::Index n = problem.n_rings();

  NormalHistory history{n_steps, 0, infinity, {}, {}, {}, Eigen::VectorXd::Constant(n, infinity), {}};
  history.pressure.resize(n, static_cast<Eigen::Index>(motion.n_ramp_cycles + 8) * n_steps + 1);

  const auto start = normal_contact(problem, profile, motion.indentation);
  history.pressure.col(0) = relaxation.relaxed * start.pressure;
  State state{(motion.indentation - profile.array() + start.gap.array()).matrix(),
              Eigen::MatrixXd::Zero(n, static_cast<Eigen::Index>(relaxation.moduli.size())),
              std::vector<BoxState>(static_cast<std::size_t>(n), BoxState::lower)};
  for (Eigen::Index i = 0; i < n; ++i)
    if (start.pressure[i] > 0) state.contact[i] = BoxState::interior;

  auto now = normal_motion(motion, 0);
  while (!(history.periodicity <= control.periodicity)) {
    if (history.n_cycles >= control.max_cycles)
      throw SolverError("the normal response is not periodic after " + std::to_string(history.n_cycles) +
                        " cycles: it still changes by " + std::to_string(history.periodicity) +
                        " of its largest value per cycle");
    history.smallest_gap.setConstant(infinity);
    double deepest = -infinity;
    const Eigen::Index first = static_cast<Eigen::Index>(history.n_cycles) * n_steps;
    if (history.pressure.cols() < first + n_steps + 1)
      history.pressure.conservativeResize(Eigen::NoChange, 2 * history.pressure.cols());
    for (int k = 1; k <= n_steps; ++k) {
      const double t = dt * static_cast<double>(first + k);
      const auto next = normal_motion(motion, t);
      const StepRates rates{now.rate, normal_motion(motion, t - dt / 2).rate, next.rate};
      const double increment = next.value - now.value;
      const Eigen::VectorXd held = step.response_without_slip(state.displacement, state.memory, increment, rates);
      // In contact the gap closes: the ring slips by what is left of its gap.
      const Eigen::VectorXd gap = (state.displacement - (now.value - profile.array()).matrix());
      const Eigen::VectorXd target = held - step.instantaneous() * gap;
      const auto contact = solve_contact(problem, target, state.contact);
      const Eigen::VectorXd new_gap = contact.gap / step.instantaneous();
      step.advance(state.displacement, state.memory, increment, rates, gap - new_gap);
      history.pressure.col(first + k) = contact.pressure;
      history.smallest_gap = history.smallest_gap.cwiseMin(new_gap);
      if (next.value > deepest) {
        deepest = next.value;
        history.largest_displacement = state.displacement;
      }
      now = next;
    }
    ++history.n_cycles;
    require_room(history.pressure.rightCols(history.pressure.cols() - first).leftCols(n_steps + 1).rowwise().maxCoeff());
    if (history.n_cycles > motion.n_ramp_cycles) {
      const auto last = history.pressure.middleCols(first + 1, n_steps);
      const auto before = history.pressure.middleCols(first + 1 - n_steps, n_steps);
      history.periodicity = (last - before).cwiseAbs().maxCoeff() / last.maxCoeff();
    }
  }
  history.pressure.conservativeResize(Eigen::NoChange, static_cast<Eigen::Index>(history.n_cycles) * n_steps + 1);
  history.force = history.pressure.transpose() * problem.compliance.areas;
  history.indentation.resize(history.force.size());
  for (Eigen::Index k = 0; k < history.indentation.size(); ++k)
    history.indentation[k] = normal_motion(motion, dt * static_cast<double>(k)).value;
  return history;
}

}  // namespace fretval::fem
