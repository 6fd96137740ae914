#include "fem/full_contact/normal_solver.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "fem/full_contact/conjugate_gradients.h"
#include "fem/support/solver_error.h"

namespace fretval::fem {

using Eigen::MatrixXd;

namespace {

class ActiveSet {
 public:
  ActiveSet(const SurfaceOperator& op, const InverseOperator& inverse, const MatrixXd& target, const MatrixXd& guess)
      : op_(op), inverse_(inverse), scale_(op.diagonal().cwiseInverse()), pressure_(guess.cwiseMax(0)) {
    op.apply(pressure_, image_);
    pull_ = target - image_;
  }

  /// Whether the solution is found.
  bool is_done(double enough) {
    remainder_ = remainder(pressure_, pull_);
    return remainder_ <= enough;
  }

  void iterate() {
    ++n_iterations_;
    const MatrixXd way = newton_step();
    op_.apply(way, image_);
    if (remainder(pressure_ + way, pull_ - image_) < remainder_ / 2) return go(way, 1);
    const double share = share_of_descent(way);
    if (share > 0) return go(way, share);
    const MatrixXd down = led(pressure_, pull_).cwiseMax(0) - pressure_;
    op_.apply(down, image_);
    go(down, std::max(0.0, share_of_descent(down)));
  }

  [[nodiscard]] int n_iterations() const { return n_iterations_; }
  [[nodiscard]] double remainder_left() const { return remainder_; }
  [[nodiscard]] PressureSolution solution() const {
    return {pressure_, (pressure_.array() > 0).select(0, (-pull_).cwiseMax(0)), remainder_, n_iterations_};
  }

 private:
  [[nodiscard]] MatrixXd led(const MatrixXd& pressure, const MatrixXd& pull) const {
    return pressure + scale_.asDiagonal() * pull;
  }

  [[nodiscard]] double remainder(const MatrixXd& pressure, const MatrixXd& pull) const {
    const double left = (led(pressure, pull).cwiseMax(0) - pressure.cwiseMax(0)).lpNorm<Eigen::Infinity>();
    return left == 0 ? 0 : left / std::max(pressure.maxCoeff(), left);
  }

  MatrixXd newton_step() {
    const MatrixXd pressed = (led(pressure_, pull_).array() > 0).cast<double>();
    const MatrixXd onto = pressure_.cwiseProduct(pressed);
    op_.apply(onto - pressure_, image_);
    const MatrixXd right = (pull_ - image_).cwiseProduct(pressed);
    const auto apply = [&](const MatrixXd& field, MatrixXd& result) {
      op_.apply(field, result);
      result = result.cwiseProduct(pressed);
    };
    const auto precondition = [&](const MatrixXd& field, MatrixXd& result) {
      inverse_.apply(field, result);
      result = result.cwiseProduct(pressed);
    };
    MatrixXd step;
    conjugate_gradients(apply, precondition, right, share_for(remainder_), most_applications, step);
    return (onto + step).cwiseMax(0) - pressure_;
  }

  [[nodiscard]] double share_of_descent(const MatrixXd& way) const {
    return std::min(1.0, way.cwiseProduct(pull_).sum() / way.cwiseProduct(image_).sum());
  }

  void go(const MatrixXd& way, double share) {
    pressure_ = (pressure_ + share * way).cwiseMax(0);  // all of the way leaves roundoff of pressures that vanish
    pull_ -= share * image_;
  }

  const SurfaceOperator& op_;
  const InverseOperator& inverse_;
  Eigen::VectorXd scale_;
  MatrixXd pressure_, pull_, image_;
  double remainder_ = 0;
  int n_iterations_ = 0;
};

}  // namespace

PressureSolution solve_pressure(const SurfaceOperator& op, const MatrixXd& target, const MatrixXd& guess) {
  return solve_pressure(op, InverseOperator(op, Eigen::VectorXd::Zero(op.n_rings())), target, guess);
}

PressureSolution solve_pressure(const SurfaceOperator& op, const InverseOperator& inverse, const MatrixXd& target,
                                const MatrixXd& guess, double enough) {
  if (target.rows() != op.n_rings() || target.cols() != op.n_columns() || guess.rows() != target.rows() ||
      guess.cols() != target.cols())
    throw std::invalid_argument("the fields of the normal contact do not fit its operator");
  if (!target.allFinite() || !guess.allFinite())
    throw std::invalid_argument("the displacements of the normal contact must be numbers");
  ActiveSet set(op, inverse, target, guess);
  while (!set.is_done(enough)) {
    if (set.n_iterations() == most_newton_steps)
      throw SolverError(
          fmt::format("the normal contact on rings and angles does not converge: {:.1e} of the largest "
                      "pressure is left after {} iterations, {:.1e} is asked for",
                      set.remainder_left(), most_newton_steps, enough));
    set.iterate();
  }
  return set.solution();
}

}  // namespace fretval::fem
