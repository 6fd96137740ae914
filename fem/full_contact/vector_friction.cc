#include "fem/full_contact/vector_friction.h"

#include <cmath>
#include <utility>

#include "fem/full_contact/fields.h"

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
          [&motion](double t, double inside) { return transverse_motion_inside(motion, t, inside); }};
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

const FrictionSolution& VectorFriction::attempt(const MatrixXd& pressure, const MatrixXd& displaced, double enough) {
  const auto next = next_step();
  const auto response = [&](const RingState& state, const Course& course) {
    return step_.response_without_slip(state, move_in(course, next.begin, next.balance, next.inside()));
  };
  const VectorXd x = response(x_, motion_.x), y = response(y_, motion_.y);
  MatrixXd pull(traction.rows(), traction.cols());
  pull << as_field(x, limit.rows()), as_field(y, limit.rows());
  pull = op_.areas().asDiagonal() * pull;
  pull -= displaced;
  limit = friction_coefficient_ * pressure;
  solution_ = solve_friction(op_, pull, limit, solution_.traction, enough);
  return solution_;
}

void VectorFriction::accept() {
  const Index m = limit.cols();
  const auto next = next_step();
  traction_before = std::exchange(traction, solution_.traction);
  slip = (op_.areas() * step_.instantaneous()).cwiseInverse().asDiagonal() * solution_.residual;
  const auto x = move_in(motion_.x, next.begin, next.end, next.inside()),
             y = move_in(motion_.y, next.begin, next.end, next.inside());
  step_.advance(x_, x, as_vector(slip.leftCols(m)));
  step_.advance(y_, y, as_vector(slip.rightCols(m)));
  increment = {x.increment, y.increment};
  displacement += increment;
  n_iterations = solution_.iterations;
  n_applications = solution_.applications;
  ++n_steps;
}

void VectorFriction::step(const MatrixXd& pressure) {
  attempt(pressure, MatrixXd::Zero(traction.rows(), traction.cols()));
  accept();
}

void VectorFriction::step(const VectorXd& ring_pressure) {
  step(MatrixXd(ring_pressure.replicate(1, limit.cols())));
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

double VectorFriction::friction_work() const {
  const MatrixXd middle = (1.5 - fraction()) * traction + (fraction() - 0.5) * traction_before;
  return (op_.areas().transpose() * middle.cwiseProduct(slip)).sum();
}

}  // namespace fretval::fem
