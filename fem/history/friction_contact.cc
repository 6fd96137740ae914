#include "fem/history/friction_contact.h"

#include <utility>

#include "fem/support/constants.h"

namespace fretval::fem {
FrictionContact::FrictionContact(const ContactProblem& problem, const RelaxationModel& relaxation,
                                 double friction_coefficient, const Motion& motion, int steps_per_cycle)
    : limit(Eigen::VectorXd::Zero(problem.n_rings())),
      limit_depths(limit),
      traction(limit),
      slip(limit),
      state{limit, Eigen::MatrixXd::Zero(limit.size(), static_cast<Eigen::Index>(relaxation.moduli.size()))},
      zones(limit.size()),
      problem_(problem),
      relaxation_(relaxation),
      friction_coefficient_(friction_coefficient),
      motion_(motion),
      steps_per_cycle_(steps_per_cycle),
      dt_(2 * pi / steps_per_cycle),
      step_(relaxation, dt_),
      stick_(static_cast<std::size_t>(limit.size()), BoxState::interior) {}

void FrictionContact::step(const Eigen::VectorXd& pressure) {
  const auto position = [this](double t) { return tangential_motion(motion_, t); };
  const double begin = dt_ * static_cast<double>(n_steps);
  const auto& areas = problem_.compliance.areas;
  limit = friction_coefficient_ * pressure;
  limit_depths = friction_coefficient_ * problem_.series.depths(pressure);
  const auto to_balance = indenter_move(position, begin, begin + step_.fraction() * dt_);
  const Eigen::VectorXd held = step_.response_without_slip(state, to_balance);
  auto solution = problem_.solver.solve(areas.cwiseProduct(held), -limit, limit, stick_);
  zones.update(limit, stick_, problem_.series.depths(solution.x));
  for (std::size_t i = 0; i < stick_.size(); ++i)
    if (limit[static_cast<Eigen::Index>(i)] == 0)
      stick_[i] = BoxState::interior;  // the guess for when it touches again
  slip = (solution.residual.array() / areas.array()).matrix() / step_.instantaneous();
  step_.advance(state, indenter_move(position, begin, begin + dt_), slip);
  traction = std::move(solution.x);
  ++n_steps;
}

}  // namespace fretval::fem
