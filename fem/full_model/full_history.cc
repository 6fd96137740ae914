#include "fem/full_model/full_history.h"

#include <functional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "fem/contact/require_room.h"
#include "fem/full_model/strain_field.h"
#include "fem/ring_contact/ring_courses.h"
#include "fem/support/constants.h"
#include "fem/support/solver_error.h"

namespace fretval::fem {
namespace {

/// Tractions that move all rings by given displacements, against forces on the body.
BorderedSolver::Solution moved(BorderedSolver& solver, const Eigen::VectorXd& force, const Eigen::VectorXd& rings) {
  const Eigen::VectorXd any = Eigen::VectorXd::Constant(rings.size(), infinity);
  std::vector<BoxState> held(static_cast<std::size_t>(rings.size()), BoxState::interior);
  return solver.solve(force, rings, -any, any, held);
}

Eigen::VectorXd driven_field(BorderedSolver& solver, const Eigen::VectorXd& rings) {
  return moved(solver, Eigen::VectorXd::Zero(solver.count().n_dofs), rings).field;
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
        driven_(driven_field(solver, Eigen::VectorXd::Ones(solver.n_rings()))),
        driven_strain_(strain_.of(driven_)),
        state_{strain_.of(displacement),
               Eigen::MatrixXd::Zero(driven_strain_.size(), static_cast<Eigen::Index>(relaxation.moduli.size()))},
        displacement_(std::move(displacement)) {}

  /// Ring tractions at the balance time of a step in which the body stands still.
  Eigen::VectorXd standing() {
    const Eigen::VectorXd force = strain_.force(step_.response_without_slip(state_, standing_still));
    return moved(solver_, force, Eigen::VectorXd::Zero(solver_.n_rings())).traction;
  }

  /// How far rings follow the indenter in the next step, and where they turn.
  void drive(const RingCourses& courses) {
    driven_ = driven_field(solver_, courses.driven);
    driven_strain_ = strain_.of(driven_);
    const auto strain_of = [this](const Eigen::VectorXd& rings) { return strain_.of(driven_field(solver_, rings)); };
    turn_response_.resize(0);
    if (!courses.has_turns) return;
    turn_response_ = strain_of(courses.response);
    turn_memory_.resize(driven_strain_.size(), courses.memory.cols());
    for (Eigen::Index branch = 0; branch < courses.memory.cols(); ++branch)
      turn_memory_.col(branch) = strain_of(courses.memory.col(branch));
  }

  /// Ring tractions at the balance time of a step. Interior rings slip by the given amount, the others have tractions
  /// at the bounds.
  Eigen::VectorXd compute_step(int index, const Eigen::VectorXd& interior_slip, const Eigen::VectorXd& lower,
                               const Eigen::VectorXd& upper, std::vector<BoxState>& state) {
    Eigen::VectorXd response = step_.response_without_slip(state_, to_balance(index), driven_strain_);
    if (turn_response_.size() > 0) response += turn_response_;
    const Eigen::VectorXd force = strain_.force(response);
    auto solution = solver_.solve(force, -step_.instantaneous() * interior_slip, lower, upper, state);
    const Eigen::VectorXd slip = -solution.field / step_.instantaneous();
    const auto move = indenter_move(motion_, time(index), time(index) + dt_);
    step_.advance(state_, move, strain_.of(slip), driven_strain_);
    if (turn_response_.size() > 0) state_.memory += turn_memory_;
    displacement_ += move.increment * driven_ - slip;
    return std::move(solution.traction);
  }

  [[nodiscard]] double time(int index) const { return dt_ * index; }
  [[nodiscard]] const RelaxationStep& step() const { return step_; }
  [[nodiscard]] IndenterMove to_balance(int index) const {
    return indenter_move(motion_, time(index), time(index) + step_.fraction() * dt_);
  }
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
  RingState state_;                // strains
  Eigen::VectorXd turn_response_;  // strains; see RingCourses
  Eigen::MatrixXd turn_memory_;
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
  require(space.order() == axisymmetric, "the normal history takes a space of the normal harmonic");
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
    const Eigen::VectorXd gap = (stepper.ring_displacement() + profile).array() - position(stepper.time(k)).value;
    RingCourses courses{Eigen::VectorXd::Ones(n)};
    if (relaxation.has_memory()) {
      const RingsAtStart rings{series.depths(before), series.depths(stepper.standing()), series.displacements(gap)};
      find_courses(series, stepper.step(), rings, stepper.to_balance(k), stepper.increment(k), courses);
      stepper.drive(courses);
    }
    // A ring in contact closes its gap: it slips by what is left of it.
    const Eigen::VectorXd slip = gap - courses.left_behind(stepper.increment(k));
    history.pressure.col(k + 1) = stepper.compute_step(k, slip, lower, upper, contact);
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
  require(space.order() == lateral, "the friction history takes a space of the tangential harmonic");
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
