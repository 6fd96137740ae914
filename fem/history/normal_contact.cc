#include "fem/history/normal_contact.h"

#include <algorithm>
#include <utility>

#include "fem/history/require_room.h"
#include "fem/support/constants.h"
#include "fem/support/solver_error.h"

namespace fretval::fem {
namespace {

PressureAtEdge pressure_at_edge(const RelaxationModel& relaxation) {
  if (relaxation.viscosity == 0) return PressureAtEdge::vanishes;
  return relaxation.moduli.empty() ? PressureAtEdge::jumps : PressureAtEdge::falls_and_jumps;
}

}  // namespace

NormalContact::NormalContact(const ContactProblem& problem, const RelaxationModel& relaxation, Eigen::VectorXd shape,
                             const Motion& motion, int steps_per_cycle)
    : profile(std::move(shape)),
      state{{}, Eigen::MatrixXd::Zero(profile.size(), static_cast<Eigen::Index>(relaxation.moduli.size()))},
      problem_(problem),
      relaxation_(relaxation),
      motion_(motion),
      steps_per_cycle_(steps_per_cycle),
      dt_(2 * pi / steps_per_cycle),
      step_(relaxation, dt_),
      edge_(pressure_at_edge(relaxation)),
      contact_(static_cast<std::size_t>(profile.size()), BoxState::lower) {
  const double depth = normal_motion(motion, 0).value;
  const auto contact = static_contact(problem, profile, depth);
  state.displacement = (depth - profile.array() + contact.gap.array()).matrix();
  for (Eigen::Index i = 0; i < profile.size(); ++i)
    if (contact.pressure[i] > 0) contact_[static_cast<std::size_t>(i)] = BoxState::interior;
  gap = balance_gap = contact.gap;
  pressure = contact.pressure;
  read(contact.gap, {});
  reading.force *= relaxation.relaxed;
  pressure *= relaxation.relaxed;
}

double NormalContact::indentation() const {
  return normal_motion(motion_, dt_ * static_cast<double>(n_steps)).value;
}

/// Rings that are in contact at the beginning of a step, if a dashpot makes that matter.
std::optional<Eigen::Index> NormalContact::n_closed() const {
  constexpr double hardly_viscous = 0.99, roundoff = 1e-12;
  if (step_.fraction() > hardly_viscous) return std::nullopt;
  return (gap.array() <= roundoff * gap.maxCoeff()).count();
}

void NormalContact::read(const Eigen::VectorXd& gap_then, const ContactPast& past) {
  reading = contact_force(problem_.series, pressure, gap_then, past);
  largest_radius_ = std::max(largest_radius_, reading.radius);
}

void NormalContact::step(const PressureWear& wear) {
  const auto position = [this](double t) { return normal_motion(motion_, t); };
  const double begin = dt_ * static_cast<double>(n_steps), weight = step_.fraction();
  time = begin + weight * dt_;
  gap = state.displacement + profile;
  gap.array() -= position(begin).value;
  // A ring in contact closes its gap: it slips by what is left of it.
  const Eigen::VectorXd held = step_.response_without_slip(state, indenter_move(position, begin, time));
  const Eigen::VectorXd target = held - step_.instantaneous() * gap;
  auto contact =
      solve_wearing_contact(problem_, target, {step_.instantaneous() * wear.coefficient, wear.exponent}, contact_);
  const Eigen::VectorXd new_gap = contact.gap / step_.instantaneous();
  Eigen::VectorXd slip = gap - new_gap;
  if (wear.coefficient.size() > 0) {
    const Eigen::VectorXd worn =
        wear.coefficient.cwiseProduct(contact.pressure.array().max(0).pow(wear.exponent).matrix());
    profile += worn;
    slip += worn;
  }
  step_.advance(state, indenter_move(position, begin, begin + dt_), slip);
  balance_gap = weight * new_gap + (1 - weight) * gap;
  pressure = std::move(contact.pressure);
  read(balance_gap, {largest_radius_, n_closed(), edge_});
  gap = new_gap;
  ++n_steps;
  require_room(pressure);
}

}  // namespace fretval::fem
