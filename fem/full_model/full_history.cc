#include "fem/full_model/full_history.h"

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "fem/contact/require_room.h"
#include "fem/contact/static_contact.h"
#include "fem/full_model/strain_field.h"
#include "fem/support/constants.h"
#include "fem/support/solver_error.h"

namespace fretval::fem {
namespace {

/// Of a body whose rings move by given displacements, and are free beyond the last one that moves.
Eigen::VectorXd driven_field(BorderedSolver& solver, const Eigen::VectorXd& rings, Eigen::Index n_moved) {
  const Eigen::Index n = solver.n_rings();
  Eigen::VectorXd most = Eigen::VectorXd::Zero(n);
  most.head(n_moved).setConstant(infinity);
  std::vector<BoxState> held(static_cast<std::size_t>(n), BoxState::lower);
  std::fill_n(held.begin(), n_moved, BoxState::interior);
  return solver.solve(Eigen::VectorXd::Zero(solver.count().n_dofs), rings, -most, most, held).field;
}

/// Carries the body from step to step.
class Stepper {
 public:
  /// displacement: the relaxed field at the start. At first all rings move with the indenter.
  Stepper(const HarmonicSpace& space, BorderedSolver& solver, const RelaxationModel& relaxation,
          std::function<ValueAndRate(double)> motion, int steps_per_cycle, Eigen::VectorXd displacement)
      : solver_(solver),
        strain_(space),
        motion_(std::move(motion)),
        dt_(2 * pi / steps_per_cycle),
        step_(relaxation, dt_),
        driven_(driven_field(solver, Eigen::VectorXd::Ones(solver.n_rings()), solver.n_rings())),
        driven_strain_(strain_.of(driven_)),
        state_{strain_.of(displacement),
               Eigen::MatrixXd::Zero(driven_strain_.size(), static_cast<Eigen::Index>(relaxation.moduli.size()))},
        displacement_(std::move(displacement)) {}

  /// How far rings follow the indenter from now on, of which n_moved do not by themselves.
  void drive(const Eigen::VectorXd& rings, Eigen::Index n_moved) {
    driven_ = driven_field(solver_, rings, n_moved);
    driven_strain_ = strain_.of(driven_);
  }

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
  [[nodiscard]] double instantaneous() const { return step_.instantaneous(); }
  [[nodiscard]] double increment(int index) const {
    return motion_(time(index + 1)).value - motion_(time(index)).value;
  }
  [[nodiscard]] Eigen::VectorXd ring_displacement() const { return solver_.ring_means(displacement_); }

 private:
  BorderedSolver& solver_;
  StrainField strain_;
  std::function<ValueAndRate(double)> motion_;
  double dt_;
  RelaxationStep step_;
  Eigen::VectorXd driven_;  // a field, as displacement_; what they hold at the dofs of the pressure has no meaning
  Eigen::VectorXd driven_strain_;
  RingState state_;  // strains
  Eigen::VectorXd displacement_;
};

void require(bool condition, const char* message) {
  if (!condition) throw std::invalid_argument(message);
}

}  // namespace

FullNormalHistory full_normal_history(const HarmonicSpace& space, const PunchSeries& series,
                                      const RelaxationModel& relaxation, const Eigen::VectorXd& profile,
                                      const Motion& motion, int steps_per_cycle, int n_cycles, SparseFactors factors) {
  const Eigen::Index n = space.contact_line().n_elements();
  require(space.harmonic() == Harmonic::normal, "the normal history takes a space of the normal harmonic");
  require(profile.size() == n, "the profile of the indenter does not fit the rings of the contact line");
  const auto position = [&motion](double t) { return normal_motion(motion, t); };
  const int n_steps = n_cycles * steps_per_cycle;
  const Eigen::VectorXd lower = Eigen::VectorXd::Zero(n), upper = Eigen::VectorXd::Constant(n, infinity);
  BorderedSolver solver(space, "the full normal problem", factors);

  const Eigen::VectorXd depth = position(0).value - profile.array();
  std::vector<BoxState> contact(static_cast<std::size_t>(n), BoxState::lower);
  for (Eigen::Index i = 0; i < n; ++i)
    if (depth[i] > 0) contact[static_cast<std::size_t>(i)] = BoxState::interior;
  auto relaxed = solver.solve(Eigen::VectorXd::Zero(space.n_dofs()), depth, lower, upper, contact);

  FullNormalHistory history;
  history.pressure.resize(n, 1 + n_steps);
  history.pressure.col(0) = relaxation.relaxed * relaxed.traction;
  Stepper stepper(space, solver, relaxation, position, steps_per_cycle, std::move(relaxed.field));
  for (int k = 0; k < n_steps; ++k) {
    const Eigen::VectorXd before = history.pressure.col(k);
    const double increment = stepper.increment(k);
    const Eigen::VectorXd driven = driven_by_indenter(series, before, stepper.instantaneous() * increment);
    Eigen::Index n_moved = n;
    while (n_moved > 0 && before[n_moved - 1] == 0) --n_moved;
    stepper.drive(driven, n_moved);
    // A ring in contact closes its gap: it slips by what is left of it.
    const Eigen::VectorXd gap = (stepper.ring_displacement() + profile).array() - position(stepper.time(k)).value;
    const Eigen::VectorXd by_itself = (1 - driven.array()) * increment;
    history.pressure.col(k + 1) = stepper.compute_step(k, gap - by_itself, lower, upper, contact);
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
  Stepper stepper(
      space, solver, relaxation, [&motion](double t) { return tangential_motion(motion, t); }, steps_per_cycle,
      Eigen::VectorXd::Zero(space.n_dofs()));

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
