#include "fem/full_contact/normal_solver.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

#include "fem/full_contact/conjugate_gradients.h"
#include "fem/support/solver_error.h"

namespace fretval::fem {

using Eigen::MatrixXd;

namespace {

/// Inverse of the diagonal.
MatrixXd scale_of(const SurfaceOperator& op, const MatrixXd& softness) {
  const MatrixXd diagonal = op.diagonal().replicate(1, op.n_columns());
  return (softness.size() > 0 ? MatrixXd(diagonal + softness) : diagonal).cwiseInverse();
}

double remainder_of(const MatrixXd& scale, const MatrixXd& pressure, const MatrixXd& pull) {
  const MatrixXd led = pressure + scale.cwiseProduct(pull);
  const double left = (led.cwiseMax(0) - pressure.cwiseMax(0)).lpNorm<Eigen::Infinity>();
  return left == 0 ? 0 : left / std::max(pressure.maxCoeff(), left);
}

class ActiveSet {
 public:
  /// softness: empty, or D.
  ActiveSet(const SurfaceOperator& op, const InverseOperator& inverse, const MatrixXd& softness, const MatrixXd& target,
            const MatrixXd& guess)
      : op_(op), inverse_(inverse), softness_(softness), scale_(scale_of(op, softness)), pressure_(guess.cwiseMax(0)) {
    apply(pressure_, image_);
    pull_ = target - image_;
  }

  /// Whether the solution is found.
  bool is_done(double enough) {
    remainder_ = remainder_of(scale_, pressure_, pull_);
    least_remainder_ = std::min(least_remainder_, remainder_);
    return remainder_ <= enough;
  }

  void iterate(double enough) {
    ++n_iterations_;
    const MatrixXd way = newton_step(enough);
    apply(way, image_);
    if (remainder_of(scale_, pressure_ + way, pull_ - image_) < least_remainder_ / 2) return go(way, 1);
    const double share = share_of_descent(way);
    if (share > 0) return go(way, share);
    const MatrixXd down = led().cwiseMax(0) - pressure_;
    apply(down, image_);
    go(down, std::max(0.0, share_of_descent(down)));
  }

  [[nodiscard]] int n_iterations() const { return n_iterations_; }
  [[nodiscard]] double remainder_left() const { return remainder_; }
  [[nodiscard]] PressureSolution solution() const {
    return {pressure_, (pressure_.array() > 0).select(0, (-pull_).cwiseMax(0)), remainder_, n_iterations_};
  }

 private:
  void apply(const MatrixXd& field, MatrixXd& result) const {
    op_.apply(field, result);
    if (softness_.size() > 0) result += softness_.cwiseProduct(field);
  }

  [[nodiscard]] MatrixXd led() const { return pressure_ + scale_.cwiseProduct(pull_); }

  MatrixXd newton_step(double enough) {
    const MatrixXd pressed = (led().array() > 0).cast<double>();
    const MatrixXd onto = pressure_.cwiseProduct(pressed);
    apply(onto - pressure_, image_);
    const MatrixXd right = (pull_ - image_).cwiseProduct(pressed);
    const auto apply_pressed = [&](const MatrixXd& field, MatrixXd& result) {
      apply(field, result);
      result = result.cwiseProduct(pressed);
    };
    const auto precondition = [&](const MatrixXd& field, MatrixXd& result) {
      inverse_.apply(field, result);
      result = result.cwiseProduct(pressed);
    };
    MatrixXd step;
    conjugate_gradients(apply_pressed, precondition, right, share_for(remainder_, enough), most_applications, step);
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
  const MatrixXd& softness_;
  MatrixXd scale_, pressure_, pull_, image_;
  double remainder_ = 0, least_remainder_ = std::numeric_limits<double>::infinity();
  int n_iterations_ = 0;
};

PressureSolution solve(const SurfaceOperator& op, const InverseOperator& inverse, const MatrixXd& softness,
                       const MatrixXd& target, const MatrixXd& guess, double enough) {
  if (target.rows() != op.n_rings() || target.cols() != op.n_columns() || guess.rows() != target.rows() ||
      guess.cols() != target.cols())
    throw std::invalid_argument("the fields of the normal contact do not fit its operator");
  if (!target.allFinite() || !guess.allFinite())
    throw std::invalid_argument("the displacements of the normal contact must be numbers");
  ActiveSet set(op, inverse, softness, target, guess);
  while (!set.is_done(enough)) {
    if (set.n_iterations() == most_newton_steps)
      throw SolverError(
          fmt::format("the normal contact on rings and angles does not converge: {:.1e} of the largest "
                      "pressure is left after {} iterations, {:.1e} is asked for",
                      set.remainder_left(), most_newton_steps, enough));
    set.iterate(enough);
  }
  return set.solution();
}

}  // namespace

PressureSolution solve_pressure(const SurfaceOperator& op, const MatrixXd& target, const MatrixXd& guess) {
  return solve_pressure(op, InverseOperator(op, Eigen::VectorXd::Zero(op.n_rings())), target, guess);
}

PressureSolution solve_pressure(const SurfaceOperator& op, const InverseOperator& inverse, const MatrixXd& target,
                                const MatrixXd& guess, double enough) {
  return solve(op, inverse, {}, target, guess, enough);
}

PressureSolution solve_pressure(const SurfaceOperator& op, const MatrixXd& softness, const MatrixXd& target,
                                const MatrixXd& guess, double enough) {
  const Eigen::VectorXd ground = softness.rowwise().mean().cwiseQuotient(op.areas());
  return solve(op, InverseOperator(op, ground), softness, target, guess, enough);
}

double pressure_remainder(const SurfaceOperator& op, const MatrixXd& softness, const MatrixXd& pressure,
                          const MatrixXd& opened) {
  return remainder_of(scale_of(op, softness), pressure, -opened);
}

}  // namespace fretval::fem
