#include "fem/full_contact/projected_gradients.h"

#include <algorithm>
#include <cmath>

namespace fretval::fem {
namespace {

using Eigen::MatrixXd;

/// x that minimises x . K x/2 - q . x on what a projection maps onto.
template <class Project>
MatrixXd minimum(const SurfaceOperator& op, double eigenvalue, const MatrixXd& q, const Project& project) {
  constexpr int most_iterations = 20000;
  constexpr double no_move = 1e-12;
  MatrixXd x = MatrixXd::Zero(q.rows(), q.cols()), led = x, before, image;
  double momentum = 1;
  for (int i = 0; i < most_iterations; ++i) {
    op.apply(led, image);
    before = x;
    x = project(led + (q - image) / eigenvalue);
    const MatrixXd move = x - before;
    if (move.lpNorm<Eigen::Infinity>() <= no_move * x.lpNorm<Eigen::Infinity>()) break;
    if ((led - x).cwiseProduct(move).sum() > 0) momentum = 1;
    const double next = (1 + std::sqrt(1 + 4 * momentum * momentum)) / 2;
    led = x + (momentum - 1) / next * move;
    momentum = next;
  }
  return x;
}

double difference_over(double scale, const MatrixXd& one, const MatrixXd& other) {
  return scale > 0 ? (one - other).lpNorm<Eigen::Infinity>() / scale : 0;
}

}  // namespace

double largest_eigenvalue(const SurfaceOperator& op) {
  constexpr int iterations = 100;
  constexpr double safety = 1.01;  // the iteration comes from below
  MatrixXd image, vector = MatrixXd::Ones(op.n_rings(), op.n_columns());
  double largest = 0;
  for (int i = 0; i < iterations; ++i) {
    op.apply(vector, image);
    largest = image.norm();
    vector = image / largest;
  }
  return safety * largest;
}

MatrixXd friction_by_projected_gradients(const SurfaceOperator& op, double eigenvalue, const MatrixXd& pull,
                                         const MatrixXd& limit) {
  return minimum(op, eigenvalue, pull, [&limit](const MatrixXd& t) { return onto_discs(t, limit); });
}

MatrixXd pressure_by_projected_gradients(const SurfaceOperator& op, double eigenvalue, const MatrixXd& target) {
  return minimum(op, eigenvalue, target, [](const MatrixXd& p) { return MatrixXd(p.cwiseMax(0)); });
}

void SecondAlgorithm::see(const VectorFriction& friction) {
  const auto& op = friction.op();
  if (eigenvalue_ == 0) eigenvalue_ = largest_eigenvalue(op);
  const auto found = friction_by_projected_gradients(op, eigenvalue_, friction.pull(), friction.limit);
  difference_ = std::max(difference_, difference_over(friction.limit.maxCoeff(), found, friction.traction));
}

void SecondAlgorithm::see(const CoupledContact& contact) {
  see(contact.friction);
  const auto& op = contact.normal_operator();
  if (normal_eigenvalue_ == 0) normal_eigenvalue_ = largest_eigenvalue(op);
  const auto found = pressure_by_projected_gradients(op, normal_eigenvalue_, contact.pull());
  difference_ = std::max(difference_, difference_over(contact.pressure.maxCoeff(), found, contact.pressure));
}

}  // namespace fretval::fem
