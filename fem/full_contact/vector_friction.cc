#include "fem/full_contact/vector_friction.h"

#include <utility>

#include "fem/full_contact/fields.h"
#include "fem/support/constants.h"

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

VectorFriction::VectorFriction(const SurfaceOperator& op, RelaxationModel relaxation, double friction_coefficient,
                               const LateralMotion& motion, int steps_per_cycle)
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
      steps_per_cycle_(steps_per_cycle),
      dt_(2 * pi / steps_per_cycle),
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

const FrictionSolution& VectorFriction::attempt(const MatrixXd& pressure, const MatrixXd& displaced) {
  const double begin = dt_ * static_cast<double>(n_steps), balance = begin + step_.fraction() * dt_;
  const VectorXd x = step_.response_without_slip(x_, indenter_move(motion_.x, begin, balance)),
                 y = step_.response_without_slip(y_, indenter_move(motion_.y, begin, balance));
  MatrixXd pull(traction.rows(), traction.cols());
  pull << as_field(x, limit.rows()), as_field(y, limit.rows());
  pull = op_.areas().asDiagonal() * pull;
  pull -= displaced;
  limit = friction_coefficient_ * pressure;
  solution_ = solve_friction(op_, pull, limit, solution_.traction);
  return solution_;
}

void VectorFriction::accept() {
  const Index m = limit.cols();
  const double begin = dt_ * static_cast<double>(n_steps);
  traction_before = std::exchange(traction, solution_.traction);
  slip = (op_.areas() * step_.instantaneous()).cwiseInverse().asDiagonal() * solution_.residual;
  const auto x = indenter_move(motion_.x, begin, begin + dt_), y = indenter_move(motion_.y, begin, begin + dt_);
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
