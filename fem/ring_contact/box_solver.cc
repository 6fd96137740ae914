#include "fem/ring_contact/box_solver.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "fem/condensation/compliance.h"
#include "fem/support/dense.h"
#include "fem/support/solver_error.h"

namespace fretval::fem {

using Eigen::Index;

namespace {

constexpr int patience = 8;  // block iterations without fewer violations before single changes take over

bool is_finite(const Eigen::VectorXd& v) {
  return (0 * v).sum() == 0;  // allFinite goes through it one by one
}

// Puts the bounded unknowns at their bounds and the others at zero; returns how many are interior.
Index place_unknowns(const Eigen::VectorXd& lower, const Eigen::VectorXd& upper, std::vector<BoxState>& state,
                     Eigen::VectorXd& x) {
  Index n_interior = 0;
  for (Index i = 0; i < x.size(); ++i) {
    if (std::isunordered(lower[i], upper[i]))
      throw std::invalid_argument("a bound of the contact problem is not a number");
    if (lower[i] == upper[i]) state[i] = BoxState::lower;
    const double bound = state[i] == BoxState::lower ? lower[i] : upper[i];
    if (!std::isfinite(bound)) state[i] = BoxState::interior;
    x[i] = state[i] == BoxState::interior ? 0 : bound;
    n_interior += state[i] == BoxState::interior;
  }
  return n_interior;
}

std::vector<Index> interior_of(const std::vector<BoxState>& state) {
  std::vector<Index> interior;
  for (std::size_t i = 0; i < state.size(); ++i)
    if (state[i] == BoxState::interior) interior.push_back(static_cast<Index>(i));
  return interior;
}

}  // namespace

BoxSolver::BoxSolver(SharedMatrix matrix, double slack)
    : matrix_(std::move(matrix)),
      factor_(cholesky_factor(matrix_)),
      inverse_(solve_lower(factor_, Eigen::MatrixXd::Identity(matrix_->rows(), matrix_->rows()))),
      probe_(matrix_->rows()),
      scale_(Eigen::VectorXd::Ones(matrix_->rows())),
      per_scale_(scale_),
      slack_(slack) {
  for (Index i = 0; i < probe_.size(); ++i) probe_[i] = std::cos(1.0 + 0.7 * static_cast<double>(i));
  image_ = *matrix_ * probe_;
}

BoxSolver::BoxSolver(const BoxSolver& other, const Eigen::VectorXd& added, Index most_likely)
    : matrix_(other.matrix_),
      probe_(other.probe_),
      image_(other.image_ + added.cwiseProduct(other.probe_)),
      added_(added),
      scale_((matrix_->diagonal() + added).cwiseSqrt().cwiseInverse()),
      per_scale_(scale_.cwiseInverse()),
      slack_(other.slack_) {
  const Index n_likely = std::clamp<Index>(most_likely, 1, size());
  Index same = 0;
  while (same < n_likely && added[same] == 0) ++same;
  const Index n = n_likely - same;
  Eigen::MatrixXd factor = other.factor_->topLeftCorner(n_likely, n_likely);
  if (n > 0) {
    Eigen::MatrixXd rest = matrix_->block(same, same, n, n);
    if (same > 0) rest -= gram(factor.bottomLeftCorner(n, same).transpose());
    rest.diagonal() += added.segment(same, n);
    factor.bottomRightCorner(n, n) = cholesky_factor(rest);
  }
  factor_ = std::move(factor);
}

/// The residuals of the interior are set to zero, not computed. One product with a fixed vector tells whether they are:
/// probe . (q - C x) = probe . q - (C probe) . x.
void BoxSolver::check(const Eigen::VectorXd& q, const Solution& solution) const {
  constexpr double most = 1e-9;  // roundoff leaves 1e-13, an equation that does not hold something of order 1
  const double left = probe_.dot(q - solution.residual) - image_.dot(solution.x);
  const double size = probe_.cwiseAbs().dot(q.cwiseAbs()) + image_.cwiseAbs().dot(solution.x.cwiseAbs());
  if (!(std::abs(left) <= most * size))
    throw SolverError(
        fmt::format("a contact step does not fulfil its equations: {:.1e} of {:.1e} is left", left, size));
}

void BoxSolver::solve_leading_interior(const Target& target, Index k, Solution& solution) const {
  const Index n = size(), n_tail = n - k;
  auto& [x, residual, loads, iterations] = solution;
  loads = x;
  multiply_transposed(factor_, loads, k);
  x.head(k) = target.held.head(k) - loads.head(k);
  multiply_transposed(inverse_, x.head(k));
  loads.head(k) = target.held.head(k);
  residual.head(k).setZero();
  residual.tail(n_tail) = target.held.tail(n_tail) - loads.tail(n_tail);
  multiply_trailing(factor_, residual.tail(n_tail));
}

// Interior = leading block {0..k-1} plus a few extra indices, eliminated by their own Schur complement. x: the
// right-hand side on entry, where it is interior.
void BoxSolver::solve_interior(const std::vector<Index>& interior, Index k, Eigen::VectorXd& x) const {
  const auto block = factor_->topLeftCorner(k, k).triangularView<Eigen::Lower>();
  const Index n_extra = static_cast<Index>(interior.size()) - k;
  auto head = x.head(k);
  solve_leading(factor_, head);
  if (n_extra > 0) {
    Eigen::MatrixXd coupling(k, n_extra), extra(n_extra, n_extra);
    Eigen::VectorXd tail(n_extra);
    for (Index j = 0; j < n_extra; ++j) {
      coupling.col(j) = matrix_->col(interior[k + j]).head(k);
      tail[j] = x[interior[k + j]];
      for (Index i = 0; i < n_extra; ++i) extra(i, j) = (*matrix_)(interior[k + i], interior[k + j]);
      if (added_.size() > 0) extra(j, j) += added_[interior[k + j]];
    }
    block.solveInPlace(coupling);
    extra.noalias() -= coupling.transpose() * coupling;
    tail.noalias() -= coupling.transpose() * head;
    extra.llt().solveInPlace(tail);
    head.noalias() -= coupling * tail;
    for (Index j = 0; j < n_extra; ++j) x[interior[k + j]] = tail[j];
  }
  block.transpose().solveInPlace(head);  // BLAS takes half as long again at 36 rings
}

// What the bounded unknowns leave, then what the interior ones leave of that.
void BoxSolver::solve_any_interior(const Eigen::VectorXd& q, const std::vector<Index>& interior, Index k,
                                   Solution& solution) const {
  const Index n = size(), n_interior = static_cast<Index>(interior.size());
  auto& [x, residual, loads, iterations] = solution;
  residual = q;
  if (added_.size() > 0) residual -= added_.cwiseProduct(x);
  if (!x.tail(n - k).isZero(0)) subtract_product(matrix_, 0, k, x.tail(n - k), residual);
  for (const auto i : interior) x[i] = residual[i];
  solve_interior(interior, k, x);
  subtract_product(matrix_, k, 0, x.head(k), residual.tail(n - k));
  for (Index j = k; j < n_interior; ++j)
    residual.tail(n - k).noalias() -= x[interior[j]] * matrix_->col(interior[j]).tail(n - k);
  for (const auto i : interior) residual[i] = 0;
  if (added_.size() > 0) return;
  loads = x;
  multiply_transposed(factor_, loads);
}

void BoxSolver::hold(Target& target) const {
  if (!is_finite(target.q)) throw std::invalid_argument("the right-hand side of the contact problem is not finite");
  if (added_.size() > 0) return;
  target.held = target.q;
  multiply_trailing(inverse_, target.held);
}

BoxSolver::Solution BoxSolver::solve(const Eigen::VectorXd& q, const Eigen::VectorXd& lower,
                                     const Eigen::VectorXd& upper, std::vector<BoxState>& state) const {
  Target target{q, {}};
  hold(target);
  Solution solution;
  solve(target, lower, upper, state, solution);
  return solution;
}

void BoxSolver::solve(const Target& target, const Eigen::VectorXd& lower, const Eigen::VectorXd& upper,
                      std::vector<BoxState>& state, Solution& solution) const {
  const Index n = size();
  const int limit = 50 + 10 * static_cast<int>(n);
  const auto& q = target.q;
  auto &x = solution.x, &residual = solution.residual;
  for (auto* vector : {&x, &residual, &solution.loads}) vector->resize(n);
  const double residual_slack = slack_ * q.cwiseProduct(scale_).lpNorm<Eigen::Infinity>();
  Index fewest = std::numeric_limits<Index>::max();
  int stalled = 0;
  for (solution.iterations = 0; solution.iterations < limit; ++solution.iterations) {
    const Index n_interior = place_unknowns(lower, upper, state, x);
    Index k = 0;
    while (k < factor_->rows() && state[k] == BoxState::interior) ++k;
    if (k == n_interior && added_.size() == 0)
      solve_leading_interior(target, k, solution);
    else
      solve_any_interior(q, interior_of(state), k, solution);

    const double x_slack = slack_ * x.cwiseProduct(per_scale_).lpNorm<Eigen::Infinity>();
    const auto wanted = [&](Index i) {
      if (lower[i] == upper[i]) return state[i];
      if (state[i] == BoxState::interior) {
        const double slack = x_slack * scale_[i];
        return x[i] > upper[i] + slack ? BoxState::upper : x[i] < lower[i] - slack ? BoxState::lower : state[i];
      }
      const double slack = residual_slack * per_scale_[i];
      const bool leaves = state[i] == BoxState::upper ? residual[i] < -slack : residual[i] > slack;
      return leaves ? BoxState::interior : state[i];
    };
    Index n_violations = 0;
    for (Index i = 0; i < n; ++i) n_violations += wanted(i) != state[i];
    if (n_violations == 0) {
      check(q, solution);
      return;
    }
    stalled = n_violations < fewest ? 0 : stalled + 1;
    fewest = std::min(fewest, n_violations);
    Index n_changes = stalled > patience ? 1 : n_violations;
    for (Index i = 0; n_changes > 0; ++i)
      if (const auto to = wanted(i); to != state[i]) {
        state[i] = to;
        --n_changes;
      }
  }
  throw SolverError("the active set of a contact step did not settle in " + std::to_string(limit) + " iterations");
}

}  // namespace fretval::fem
