#include "fem/full_contact/vector_friction.h"

#include <cmath>
#include <utility>

#include "fem/contact/force_balance.h"
#include "fem/contact/gross_slip.h"
#include "fem/full_contact/fields.h"
#include "fem/full_contact/turning_slip.h"

namespace fretval::fem {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

VectorXd mean_radii(const std::vector<double>& radii) {
  VectorXd means(static_cast<Index>(radii.size()) - 1);
  for (std::size_t i = 0; i + 1 < radii.size(); ++i) {
    const double inner = radii[i], outer = radii[i + 1];
    means[static_cast<Index>(i)] = 2 * (inner * inner + inner * outer + outer * outer) / (3 * (inner + outer));
  }
  return means;
}

}  // namespace

LateralMotion lateral_motion(const Motion& motion) {
  return {[&motion](double t, double inside) { return tangential_motion_inside(motion, t, inside); },
          [&motion](double t, double inside) { return transverse_motion_inside(motion, t, inside); },
          motion.tangential_force};
}

IndenterMove move_in(const Course& course, double begin, double end, double inside) {
  return indenter_move([&](double t) { return course(t, inside); }, begin, end);
}

VectorFriction::VectorFriction(const SurfaceOperator& op, RelaxationModel relaxation, double friction_coefficient,
                               const LateralMotion& motion, StepTimes times)
    : displacement(0, 0),
      increment(0, 0),
      limit(MatrixXd::Zero(op.n_rings(), op.grid().n_kept())),
      traction(MatrixXd::Zero(limit.rows(), 2 * limit.cols())),
      traction_before(traction),
      slip(traction),
      op_(op),
      relaxation_(std::move(relaxation)),
      friction_coefficient_(friction_coefficient),
      motion_(motion),
      times_(std::move(times)),
      dt_(times_.begin(1)),
      step_(relaxation_, dt_),
      x_{VectorXd::Zero(limit.size()), MatrixXd::Zero(limit.size(), step_.n_branches())},
      y_(x_),
      solver_(op),
      guess_(traction),
      course_(times_.steps_per_cycle()),
      balance_{VectorXd::Zero(n_forces()), {}},
      expected_way_(times_.steps_per_cycle()),
      turning_(MatrixXd::Zero(traction.rows(), traction.cols())),
      arms_(mean_radii(op.radii())) {
  solution_.traction = traction;
}

void VectorFriction::start_from(const MatrixXd& at_rest) {
  const Index m = limit.cols();
  x_.displacement = as_vector(at_rest.leftCols(m));
  y_.displacement = as_vector(at_rest.rightCols(m));
}

VectorFriction::NextStep VectorFriction::next_step() {
  constexpr double roundoff = 1e-12;
  const double begin = times_.begin(n_steps), end = times_.begin(n_steps + 1);
  if (std::abs(end - begin - dt_) > roundoff * dt_) {
    dt_ = end - begin;
    step_ = RelaxationStep(relaxation_, dt_);
  }
  return {begin, begin + step_.fraction() * dt_, end, step_};
}

std::optional<StepInPiece> VectorFriction::in_piece() const {
  auto step = times_.in_piece(n_steps - 1);
  if (step) step->fraction = step_.fraction();
  return step;
}

/// Slip in the next step that is due to the turning of the traction.
MatrixXd VectorFriction::turning() const {
  return std::pow(dt_ / dt_before_, 2) * turning_;
}

VectorFriction::Moves VectorFriction::moves_in(const NextStep& next, const VectorXd& along) const {
  const auto move = [&](const Course& course, double end) { return move_in(course, next.begin, end, next.inside()); };
  const double fraction = step_.fraction();
  if (motion_.by_force) {
    const double x = along[0], y = along.size() > 1 ? along[1] : 0;
    return {steady_move(fraction * x, fraction * dt_), steady_move(fraction * y, fraction * dt_), steady_move(x, dt_),
            steady_move(y, dt_)};
  }
  return {move(motion_.x, next.balance), move(motion_.y, next.balance), move(motion_.x, next.end),
          move(motion_.y, next.end)};
}

const FrictionSolution& VectorFriction::attempt(const MatrixXd& pressure, const MatrixXd& displaced, double enough,
                                                const VectorXd& along) {
  moves_ = moves_in(next_step(), along);
  const VectorXd x = step_.response_without_slip(x_, moves_.x_to_balance),
                 y = step_.response_without_slip(y_, moves_.y_to_balance);
  MatrixXd pull(traction.rows(), traction.cols());
  pull << as_field(x, limit.rows()), as_field(y, limit.rows());
  pull -= step_.instantaneous() * turning();
  pull = op_.areas().asDiagonal() * pull;
  pull -= displaced;
  limit = friction_coefficient_ * pressure;
  solution_ = solver_.solve(pull, limit, guess_, enough);
  guess_ = solution_.traction;
  return solution_;
}

void VectorFriction::accept() {
  const Index m = limit.cols();
  const auto& [x_to_balance, y_to_balance, x, y] = moves_;
  traction_before = std::exchange(traction, solution_.traction);
  guess_ = course_.next(traction);
  const MatrixXd along_traction =
      (op_.areas() * step_.instantaneous()).cwiseInverse().asDiagonal() * solution_.residual;
  slip = along_traction + turning();
  turning_ = turning_slip(along_traction, traction, traction_before, step_.fraction());
  dt_before_ = dt_;
  step_.advance(x_, x, as_vector(slip.leftCols(m)));
  step_.advance(y_, y, as_vector(slip.rightCols(m)));
  increment = {x.increment, y.increment};
  displacement += increment;
  n_iterations = solution_.iterations;
  n_applications = solution_.applications;
  ++n_steps;
}

Index VectorFriction::n_forces() const {
  if (!motion_.by_force) return 0;
  return op_.grid().mirrors == Mirrors::none ? 2 : 1;
}

VectorXd VectorFriction::prescribed_forces() {
  const auto next = next_step();
  VectorXd forces(n_forces());
  if (forces.size() > 0) forces[0] = motion_.x(next.balance, next.inside()).value;
  if (forces.size() > 1) forces[1] = motion_.y(next.balance, next.inside()).value;
  return forces;
}

void VectorFriction::require_grip() {
  if (motion_.by_force && !(prescribed_forces().norm() < most_force())) throw GrossSlip(next_step().balance, 1);
}

VectorXd VectorFriction::attempted_forces() const {
  const Index m = limit.cols();
  VectorXd forces(n_forces());
  for (Index i = 0; i < forces.size(); ++i)
    forces[i] = (op_.areas().transpose() * solution_.traction.middleCols(i * m, m)).sum();
  return forces;
}

void VectorFriction::step(const MatrixXd& pressure) {
  const MatrixXd nothing = MatrixXd::Zero(traction.rows(), traction.cols());
  const auto go = [&](const VectorXd& along, double enough) { attempt(pressure, nothing, enough, along); };
  if (motion_.by_force) {
    limit = friction_coefficient_ * pressure;
    require_grip();
    const double size = most_force();
    const auto forces_at = [&](const VectorXd& along, double within) {
      go(along, within / size);
      return attempted_forces();
    };
    balance_ =
        displacements_for_forces(forces_at, prescribed_forces(), balance_, probe_of_force, enough_of_force * size);
  }
  go(balance_.displacements, enough_of_contact);
  if (motion_.by_force) balance_.displacements = expected_way_.next(balance_.displacements);
  accept();
}

void VectorFriction::step(const VectorXd& ring_pressure) {
  step(MatrixXd(ring_pressure.replicate(1, limit.cols())));
}

MatrixXd VectorFriction::pull() const {
  MatrixXd image;
  op_.apply(solution_.traction, image);
  return image + solution_.residual;
}

MatrixXd VectorFriction::displacements() const {
  MatrixXd all(traction.rows(), traction.cols());
  all << as_field(x_.displacement, limit.rows()), as_field(y_.displacement, limit.rows());
  return all;
}

Eigen::Vector3d VectorFriction::forces() const {
  const Index m = limit.cols();
  const VectorXd x = op_.areas().transpose() * traction.leftCols(m),
                 y = op_.areas().transpose() * traction.rightCols(m);
  if (op_.grid().mirrors != Mirrors::none) return {x.sum(), 0, 0};
  const VectorXd arms = op_.areas().cwiseProduct(arms_), cosines = op_.grid().angles.array().cos(),
                 sines = op_.grid().angles.array().sin();
  const double torque =
      (arms.transpose() * traction.rightCols(m)).dot(cosines) - (arms.transpose() * traction.leftCols(m)).dot(sines);
  return {x.sum(), y.sum(), torque};
}

MatrixXd VectorFriction::friction_work_of_points() const {
  const Index m = limit.cols();
  const MatrixXd middle = (1.5 - fraction()) * traction + (fraction() - 0.5) * traction_before,
                 work = middle.cwiseProduct(slip);
  return op_.areas().asDiagonal() * (work.leftCols(m) + work.rightCols(m));
}

}  // namespace fretval::fem
