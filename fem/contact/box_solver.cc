#include "fem/contact/box_solver.h"

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
namespace {

constexpr int patience = 8;  // block iterations without fewer violations before single changes take over

struct Violations {
  std::vector<Eigen::Index> indices;
  std::vector<BoxState> wanted;
};

/// What x and the residual may miss, of unknowns whose scale is 1.
struct Slack {
  double x, residual;
};

void find_violations(const BoxSolver::Solution& solution, const Eigen::VectorXd& lower, const Eigen::VectorXd& upper,
                     const std::vector<BoxState>& state, const Eigen::VectorXd& scale, const Eigen::VectorXd& per_scale,
                     const Slack& of_unit_scale, Violations& violations) {
  const auto &x = solution.x, &residual = solution.residual;
  violations.indices.clear();
  violations.wanted.clear();
  const auto change = [&](Eigen::Index i, BoxState to) {
    violations.indices.push_back(i);
    violations.wanted.push_back(to);
  };
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    if (lower[i] == upper[i]) continue;
    const double slack = of_unit_scale.x * scale[i], residual_slack = of_unit_scale.residual * per_scale[i];
    if (state[i] == BoxState::interior) {
      if (x[i] > upper[i] + slack) change(i, BoxState::upper);
      if (x[i] < lower[i] - slack) change(i, BoxState::lower);
    } else if (state[i] == BoxState::upper ? residual[i] < -residual_slack : residual[i] > residual_slack) {
      change(i, BoxState::interior);
    }
  }
}

// Puts the bounded unknowns at their bounds, zero elsewhere, and lists the interior ones.
void place_unknowns(const Eigen::VectorXd& lower, const Eigen::VectorXd& upper, std::vector<BoxState>& state,
                    Eigen::VectorXd& x, std::vector<Eigen::Index>& interior) {
  interior.clear();
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    if (lower[i] == upper[i]) state[i] = BoxState::lower;
    if (state[i] == BoxState::lower && !std::isfinite(lower[i])) state[i] = BoxState::interior;
    if (state[i] == BoxState::upper && !std::isfinite(upper[i])) state[i] = BoxState::interior;
    x[i] = state[i] == BoxState::interior ? 0 : state[i] == BoxState::lower ? lower[i] : upper[i];
    if (state[i] == BoxState::interior) interior.push_back(i);
  }
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
  for (Eigen::Index i = 0; i < probe_.size(); ++i) probe_[i] = std::cos(1.0 + 0.7 * static_cast<double>(i));
  image_ = *matrix_ * probe_;
}

BoxSolver::BoxSolver(const BoxSolver& other, const Eigen::VectorXd& added, Eigen::Index most_likely)
    : matrix_(other.matrix_),
      probe_(other.probe_),
      image_(other.image_ + added.cwiseProduct(other.probe_)),
      added_(added),
      scale_((matrix_->diagonal() + added).cwiseSqrt().cwiseInverse()),
      per_scale_(scale_.cwiseInverse()),
      slack_(other.slack_) {
  const Eigen::Index n_likely = std::clamp<Eigen::Index>(most_likely, 1, size());
  Eigen::Index same = 0;
  while (same < n_likely && added[same] == 0) ++same;
  const Eigen::Index n = n_likely - same;
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

void BoxSolver::solve_leading_interior(const Target& target, Eigen::Index k, Solution& solution) const {
  const Eigen::Index n = size(), n_tail = n - k;
  auto& [x, residual, loads, iterations] = solution;
  loads = x;
  multiply_transposed(factor_, loads, k);
  x.head(k) = target.held.head(k) - loads.head(k);
  multiply_transposed(inverse_, x.head(k));
  loads.head(k) = target.held.head(k);
  residual.head(k).setZero();
  multiply_trailing(factor_, (target.held - loads).tail(n_tail), residual.tail(n_tail));
}

// Interior = leading block {0..k-1} plus a few extra indices, eliminated by their own Schur complement. x: the
// right-hand side on entry, where it is interior.
void BoxSolver::solve_interior(const std::vector<Eigen::Index>& interior, Eigen::Index k, Eigen::VectorXd& x) const {
  const auto block = factor_->topLeftCorner(k, k).triangularView<Eigen::Lower>();
  const Eigen::Index n_extra = static_cast<Eigen::Index>(interior.size()) - k;
  auto head = x.head(k);
  solve_leading(factor_, head);
  if (n_extra > 0) {
    Eigen::MatrixXd coupling(k, n_extra), extra(n_extra, n_extra);
    Eigen::VectorXd tail(n_extra);
    for (Eigen::Index j = 0; j < n_extra; ++j) {
      coupling.col(j) = matrix_->col(interior[k + j]).head(k);
      tail[j] = x[interior[k + j]];
      for (Eigen::Index i = 0; i < n_extra; ++i) extra(i, j) = (*matrix_)(interior[k + i], interior[k + j]);
      if (added_.size() > 0) extra(j, j) += added_[interior[k + j]];
    }
    block.solveInPlace(coupling);
    extra.noalias() -= coupling.transpose() * coupling;
    tail.noalias() -= coupling.transpose() * head;
    extra.llt().solveInPlace(tail);
    head.noalias() -= coupling * tail;
    for (Eigen::Index j = 0; j < n_extra; ++j) x[interior[k + j]] = tail[j];
  }
  block.transpose().solveInPlace(head);  // BLAS takes half as long again at 36 rings
}

// What the bounded unknowns leave, then what the interior ones leave of that.
void BoxSolver::solve_any_interior(const Eigen::VectorXd& q, const std::vector<Eigen::Index>& interior, Eigen::Index k,
                                   Solution& solution) const {
  const Eigen::Index n = size(), n_interior = static_cast<Eigen::Index>(interior.size());
  auto& [x, residual, loads, iterations] = solution;
  residual = q;
  if (added_.size() > 0) residual -= added_.cwiseProduct(x);
  if (!x.tail(n - k).isZero(0)) subtract_product(matrix_, 0, k, x.tail(n - k), residual);
  for (const auto i : interior) x[i] = residual[i];
  solve_interior(interior, k, x);
  subtract_product(matrix_, k, 0, x.head(k), residual.tail(n - k));
  for (Eigen::Index j = k; j < n_interior; ++j)
    residual.tail(n - k).noalias() -= x[interior[j]] * matrix_->col(interior[j]).tail(n - k);
  for (const auto i : interior) residual[i] = 0;
  if (added_.size() > 0) return;
  loads = x;
  multiply_transposed(factor_, loads);
}

void BoxSolver::hold(Target& target) const {
  if (!target.q.allFinite()) throw std::invalid_argument("the right-hand side of the contact problem is not finite");
  if (added_.size() > 0) return;
  target.held.resize(size());
  multiply_trailing(inverse_, target.q, target.held);
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
  if (lower.hasNaN() || upper.hasNaN()) throw std::invalid_argument("a bound of the contact problem is not a number");
  const Eigen::Index n = size();
  const int limit = 50 + 10 * static_cast<int>(n);
  const auto& q = target.q;
  auto &x = solution.x, &residual = solution.residual;
  for (auto* vector : {&x, &residual, &solution.loads}) vector->resize(n);
  std::vector<Eigen::Index> interior;
  interior.reserve(static_cast<std::size_t>(n));
  Violations violations;
  std::size_t fewest = std::numeric_limits<std::size_t>::max();
  int stalled = 0;
  for (solution.iterations = 0; solution.iterations < limit; ++solution.iterations) {
    place_unknowns(lower, upper, state, x, interior);
    const auto n_interior = static_cast<Eigen::Index>(interior.size());
    Eigen::Index k = 0;
    while (k < n_interior && k < factor_->rows() && interior[k] == k) ++k;
    if (k == n_interior && added_.size() == 0)
      solve_leading_interior(target, k, solution);
    else
      solve_any_interior(q, interior, k, solution);

    const Slack slack{slack_ * x.cwiseProduct(per_scale_).lpNorm<Eigen::Infinity>(),
                      slack_ * q.cwiseProduct(scale_).lpNorm<Eigen::Infinity>()};
    find_violations(solution, lower, upper, state, scale_, per_scale_, slack, violations);
    if (violations.indices.empty()) {
      check(q, solution);
      return;
    }
    stalled = violations.indices.size() < fewest ? 0 : stalled + 1;
    fewest = std::min(fewest, violations.indices.size());
    const std::size_t n_changes = stalled > patience ? 1 : violations.indices.size();
    for (std::size_t j = 0; j < n_changes; ++j) state[violations.indices[j]] = violations.wanted[j];
  }
  throw SolverError("the active set of a contact step did not settle in " + std::to_string(limit) + " iterations");
}

}  // namespace fretval::fem
