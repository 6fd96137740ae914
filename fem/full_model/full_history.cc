#include "fem/full_model/full_history.h"

#include <functional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "fem/contact/require_room.h"
#include "fem/full_model/strain_field.h"
#include "fem/support/constants.h"
#include "fem/support/solver_error.h"

namespace fretval::fem {
namespace {

/// Relaxed fields of a body at the start of its history.
struct Start {
  Eigen::VectorXd displacement;  // n_dofs
  Eigen::VectorXd driven;        // n_dofs, of a body whose rings all move by 1
};

Eigen::VectorXd driven_field(BorderedSolver& solver) {
  const Eigen::Index n = solver.n_rings();
  std::vector<BoxState> all_held(static_cast<std::size_t>(n), BoxState::interior);
  return solver
      .solve(Eigen::VectorXd::Zero(solver.count().n_dofs), Eigen::VectorXd::Ones(n),
             Eigen::VectorXd::Constant(n, -infinity), Eigen::VectorXd::Constant(n, infinity), all_held)
      .field;
}

/// Carries the body from step to step.
class Stepper {
 public:
  Stepper(const HarmonicSpace& space, BorderedSolver& solver, const RelaxationModel& relaxation,
          std::function<ValueAndRate(double)> motion, int steps_per_cycle, Start start)
      : solver_(solver),
        strain_(space),
        motion_(std::move(motion)),
        dt_(2 * pi / steps_per_cycle),
        step_(relaxation, dt_),
        driven_strain_(strain_.of(start.driven)),
        state_{strain_.of(start.displacement),
               Eigen::MatrixXd::Zero(driven_strain_.size(), static_cast<Eigen::Index>(relaxation.moduli.size()))},
        driven_(std::move(start.driven)),
        displacement_(std::move(start.displacement)) {}

  /// Ring tractions at the balance time of a step. Interior rings slip by the given amount, the others have tractions
  /// at the bounds.
  Eigen::VectorXd compute_step(int index, const Eigen::VectorXd& interior_slip, const Eigen::VectorXd& lower,
                               const Eigen::VectorXd& upper, std::vector<BoxState>& state) {
    const double begin = time(index), balance = begin + step_.fraction() * dt_;
    const Eigen::VectorXd force =
        strain_.force(step_.response_without_slip(state_, indenter_move(motion_, begin, balance), driven_strain_));
    auto solution = solver_.solve(force, -step_.instantaneous() * interior_slip, lower, upper, state);
    const Eigen::VectorXd slip = -solution.field / step_.instantaneous();
    const auto move = indenter_move(motion_, begin, begin + dt_);
    step_.advance(state_, move, strain_.of(slip), driven_strain_);
    displacement_ += move.increment * driven_ - slip;
    return std::move(solution.traction);
  }

  [[nodiscard]] double time(int index) const { return dt_ * index; }
  [[nodiscard]] Eigen::VectorXd ring_displacement() const { return solver_.ring_means(displacement_); }

 private:
  BorderedSolver& solver_;
  StrainField strain_;
  std::function<ValueAndRate(double)> motion_;
  double dt_;
  RelaxationStep step_;
  Eigen::VectorXd driven_strain_;
  RingState state_;                        // strains
  Eigen::VectorXd driven_, displacement_;  // fields; what they hold at the dofs of the pressure has no meaning
};

void require(bool condition, const char* message) {
  if (!condition) throw std::invalid_argument(message);
}

}  // namespace

FullNormalHistory full_normal_history(const HarmonicSpace& space, const RelaxationModel& relaxation,
                                      const Eigen::VectorXd& profile, const Motion& motion, int steps_per_cycle,
                                      int n_cycles, SparseFactors factors) {
  const Eigen::Index n = space.contact_line().n_elements();
  require(space.harmonic() == Harmonic::normal, "the normal history takes a space of the normal harmonic");
  require(profile.size() == n, "the profile of the indenter does not fit the rings of the contact line");
  const auto position = [&motion](double t) { return normal_motion(motion, t); };
  const int n_steps = n_cycles * steps_per_cycle;
  const Eigen::VectorXd lower = Eigen::VectorXd::Zero(n), upper = Eigen::VectorXd::Constant(n, infinity);
  BorderedSolver solver(space, "the full normal problem", factors);
  Eigen::VectorXd driven = driven_field(solver);

  const Eigen::VectorXd depth = position(0).value - profile.array();
  std::vector<BoxState> contact(static_cast<std::size_t>(n), BoxState::lower);
  for (Eigen::Index i = 0; i < n; ++i)
    if (depth[i] > 0) contact[static_cast<std::size_t>(i)] = BoxState::interior;
  auto relaxed = solver.solve(Eigen::VectorXd::Zero(space.n_dofs()), depth, lower, upper, contact);

  FullNormalHistory history;
  history.pressure.resize(n, 1 + n_steps);
  history.pressure.col(0) = relaxation.relaxed * relaxed.traction;
  Stepper stepper(space, solver, relaxation, position, steps_per_cycle, {std::move(relaxed.field), std::move(driven)});
  for (int k = 0; k < n_steps; ++k) {
    // A ring in contact closes its gap: it slips by what is left of it.
    const Eigen::VectorXd gap = (stepper.ring_displacement() + profile).array() - position(stepper.time(k)).value;
    history.pressure.col(k + 1) = stepper.compute_step(k, gap, lower, upper, contact);
    require_room(history.pressure.col(k + 1));
  }
  history.count = solver.count();
  return history;
}

FullFrictionHistory full_friction_history(const HarmonicSpace& space, const RelaxationModel& relaxation,
                                          double friction_coefficient, const Motion& motion,
                                          const Eigen::MatrixXd& pressure, int steps_per_cycle, int n_cycles,
                                          SparseFactors factors) {
  const Eigen::Index n = space.contact_line().n_elements();
  const int n_steps = n_cycles * steps_per_cycle;
  require(space.harmonic() == Harmonic::tangential, "the friction history takes a space of the tangential harmonic");
  require(pressure.rows() == n && pressure.cols() >= 1 + n_steps,
          "the pressures do not fit the rings of the contact line and the steps of the friction history");
  BorderedSolver solver(space, "the full friction problem", factors);
  Start start{Eigen::VectorXd::Zero(space.n_dofs()), driven_field(solver)};
  Stepper stepper(
      space, solver, relaxation, [&motion](double t) { return tangential_motion(motion, t); }, steps_per_cycle,
      std::move(start));

  FullFrictionHistory history;
  history.traction = Eigen::MatrixXd::Zero(n, 1 + n_steps);
  std::vector<BoxState> stick(static_cast<std::size_t>(n), BoxState::interior);
  for (int k = 0; k < n_steps; ++k) {
    const Eigen::VectorXd limit = friction_coefficient * pressure.col(k + 1);
    history.traction.col(k + 1) = stepper.compute_step(k, Eigen::VectorXd::Zero(n), -limit, limit, stick);
    for (Eigen::Index i = 0; i < n; ++i)
      if (limit[i] == 0)
        stick[static_cast<std::size_t>(i)] = BoxState::interior;  // the guess for when it touches again
  }
  history.count = solver.count();
  return history;
}

}  // namespace fretval::fem
