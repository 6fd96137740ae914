#include "fem/history/box_solver.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "fem/support/solver_error.h"

namespace fretval::fem {
namespace {

constexpr int patience = 8;  // block iterations without fewer violations before single changes take over

struct Violations {
  std::vector<Eigen::Index> indices;
  std::vector<BoxState> wanted;
};

Violations find_violations(const Eigen::VectorXd& x, const Eigen::VectorXd& residual, const Eigen::VectorXd& lower,
                           const Eigen::VectorXd& upper, const std::vector<BoxState>& state, double slack,
                           double residual_slack) {
  Violations violations;
  const auto change = [&](Eigen::Index i, BoxState to) {
    violations.indices.push_back(i);
    violations.wanted.push_back(to);
  };
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    if (lower[i] == upper[i]) continue;
    if (state[i] == BoxState::interior) {
      if (x[i] > upper[i] + slack) change(i, BoxState::upper);
      if (x[i] < lower[i] - slack) change(i, BoxState::lower);
    } else if (state[i] == BoxState::upper ? residual[i] < -residual_slack : residual[i] > residual_slack) {
      change(i, BoxState::interior);
    }
  }
  return violations;
}

// Puts the bounded unknowns at their bounds, zero elsewhere, and returns the interior ones.
std::vector<Eigen::Index> place_unknowns(const Eigen::VectorXd& lower, const Eigen::VectorXd& upper,
                                         std::vector<BoxState>& state, Eigen::VectorXd& x) {
  std::vector<Eigen::Index> interior;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    if (lower[i] == upper[i]) state[i] = BoxState::lower;
    if (state[i] == BoxState::lower && !std::isfinite(lower[i])) state[i] = BoxState::interior;
    if (state[i] == BoxState::upper && !std::isfinite(upper[i])) state[i] = BoxState::interior;
    x[i] = state[i] == BoxState::interior ? 0 : state[i] == BoxState::lower ? lower[i] : upper[i];
    if (state[i] == BoxState::interior) interior.push_back(i);
  }
  return interior;
}

}  // namespace

BoxSolver::BoxSolver(const Eigen::MatrixXd& matrix, double slack) : matrix_(matrix), slack_(slack) {
  const Eigen::LLT<Eigen::MatrixXd> factor(matrix);
  if (factor.info() != Eigen::Success) throw SolverError("the contact compliance is not positive definite");
  factor_ = factor.matrixL();
}

// Interior = leading block {0..k-1} plus a few extra indices, eliminated by their own Schur complement.
void BoxSolver::solve_interior(const std::vector<Eigen::Index>& interior, Eigen::VectorXd rhs,
                               Eigen::VectorXd& x) const {
  Eigen::Index k = 0;
  const auto n = static_cast<Eigen::Index>(interior.size());
  while (k < n && interior[k] == k) ++k;
  const auto block = factor_.topLeftCorner(k, k).triangularView<Eigen::Lower>();
  const Eigen::Index n_extra = n - k;
  Eigen::VectorXd head = rhs.head(k);
  block.solveInPlace(head);
  if (n_extra > 0) {
    Eigen::MatrixXd coupling(k, n_extra), extra(n_extra, n_extra);
    Eigen::VectorXd tail(n_extra);
    for (Eigen::Index j = 0; j < n_extra; ++j) {
      coupling.col(j) = matrix_.col(interior[k + j]).head(k);
      tail[j] = rhs[k + j];
      for (Eigen::Index i = 0; i < n_extra; ++i) extra(i, j) = matrix_(interior[k + i], interior[k + j]);
    }
    block.solveInPlace(coupling);
    extra.noalias() -= coupling.transpose() * coupling;
    tail.noalias() -= coupling.transpose() * head;
    extra.llt().solveInPlace(tail);
    head.noalias() -= coupling * tail;
    for (Eigen::Index j = 0; j < n_extra; ++j) x[interior[k + j]] = tail[j];
  }
  block.transpose().solveInPlace(head);
  x.head(k) = head;
}

BoxSolver::Solution BoxSolver::solve(const Eigen::VectorXd& q, const Eigen::VectorXd& lower,
                                     const Eigen::VectorXd& upper, std::vector<BoxState>& state) const {
  if (!q.allFinite()) throw std::invalid_argument("the right-hand side of the contact problem is not finite");
  const Eigen::Index n = size();
  const int limit = 50 + 10 * static_cast<int>(n);
  Solution solution{Eigen::VectorXd::Zero(n), Eigen::VectorXd::Zero(n), 0};
  std::size_t fewest = std::numeric_limits<std::size_t>::max();
  int stalled = 0;
  for (; solution.iterations < limit; ++solution.iterations) {
    const auto interior = place_unknowns(lower, upper, state, solution.x);
    Eigen::VectorXd reduced = q;
    for (Eigen::Index i = 0; i < n; ++i)
      if (solution.x[i] != 0) reduced.noalias() -= solution.x[i] * matrix_.col(i);
    Eigen::VectorXd rhs(static_cast<Eigen::Index>(interior.size()));
    for (Eigen::Index j = 0; j < rhs.size(); ++j) rhs[j] = reduced[interior[j]];
    const Eigen::VectorXd at_bounds = solution.x;
    solve_interior(interior, std::move(rhs), solution.x);
    const Eigen::VectorXd solved = solution.x - at_bounds;
    const Eigen::Index last = interior.empty() ? 0 : interior.back() + 1;
    for (Eigen::Index i = 0; i < n; ++i)
      solution.residual[i] =
          state[i] == BoxState::interior ? 0 : reduced[i] - matrix_.col(i).head(last).dot(solved.head(last));

    const double slack = slack_ * solution.x.lpNorm<Eigen::Infinity>();
    const double residual_slack = slack_ * q.lpNorm<Eigen::Infinity>();
    const auto violations = find_violations(solution.x, solution.residual, lower, upper, state, slack, residual_slack);
    if (violations.indices.empty()) return solution;
    stalled = violations.indices.size() < fewest ? 0 : stalled + 1;
    fewest = std::min(fewest, violations.indices.size());
    const std::size_t n_changes = stalled > patience ? 1 : violations.indices.size();
    for (std::size_t j = 0; j < n_changes; ++j) state[violations.indices[j]] = violations.wanted[j];
  }
  throw SolverError("the active set of a contact step did not settle in " + std::to_string(limit) + " iterations");
}

}  // namespace fretval::fem
