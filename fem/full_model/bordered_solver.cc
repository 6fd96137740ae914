#include "fem/full_model/bordered_solver.h"

#include <map>
#include <utility>

#include "fem/operators/stiffness.h"
#include "fem/support/solver_error.h"

namespace fretval::fem {
namespace {

constexpr int iteration_limit = 100;

// Roundoff of a sparse solve, relative to the largest traction, and to the displacement it causes on a contact line of
// that length: keeps a ring that sits exactly at its limit from moving back and forth.
constexpr double slack = 1e-12;

/// `[K, -B; -B^T, 0]`, with a unit diagonal instead of B for rings that are not in the interior.
SparseMatrix bordered(const SparseMatrix& stiffness, const ContactLine& line, const std::vector<bool>& interior) {
  std::map<int, Eigen::Index> on_line;  // by dof
  for (std::size_t i = 0; i < line.dofs.size(); ++i)
    on_line[static_cast<int>(line.dofs[i])] = static_cast<Eigen::Index>(i);
  SparseMatrix matrix;
  matrix.n = stiffness.n + static_cast<int>(line.n_elements());
  matrix.row_start.push_back(0);
  const auto add = [&matrix](int column, double value) {
    matrix.columns.push_back(column);
    matrix.values.push_back(value);
  };
  const auto add_border = [&](int column, double load, Eigen::Index ring) {
    if (load != 0) add(column, interior[static_cast<std::size_t>(ring)] ? -load : 0);
  };
  for (int row = 0; row < stiffness.n; ++row) {
    for (int k = stiffness.row_start[row]; k < stiffness.row_start[row + 1]; ++k)
      add(stiffness.columns[k], stiffness.values[k]);
    if (const auto found = on_line.find(row); found != on_line.end())
      for (Eigen::Index ring = 0; ring < line.n_elements(); ++ring)
        add_border(stiffness.n + static_cast<int>(ring), line.loads(found->second, ring), ring);
    matrix.row_start.push_back(static_cast<int>(matrix.columns.size()));
  }
  for (Eigen::Index ring = 0; ring < line.n_elements(); ++ring) {
    add(stiffness.n + static_cast<int>(ring), interior[static_cast<std::size_t>(ring)] ? 0 : 1);
    matrix.row_start.push_back(static_cast<int>(matrix.columns.size()));
  }
  return matrix;
}

/// Changes the state of all rings that violate theirs; returns whether there were any.
bool change_violated(const BorderedSolver::Solution& solution, const Eigen::VectorXd& lower,
                     const Eigen::VectorXd& upper, double radius, std::vector<BoxState>& state) {
  const double traction_slack = slack * solution.traction.lpNorm<Eigen::Infinity>();
  const double residual_slack = radius * traction_slack;
  bool changed = false;
  const auto change = [&](BoxState& from, BoxState to) {
    from = to;
    changed = true;
  };
  for (Eigen::Index i = 0; i < lower.size(); ++i) {
    if (lower[i] == upper[i]) continue;
    auto& now = state[static_cast<std::size_t>(i)];
    if (now == BoxState::interior) {
      if (solution.traction[i] > upper[i] + traction_slack) change(now, BoxState::upper);
      if (solution.traction[i] < lower[i] - traction_slack) change(now, BoxState::lower);
    } else if (now == BoxState::upper ? solution.residual[i] < -residual_slack
                                      : solution.residual[i] > residual_slack) {
      change(now, BoxState::interior);
    }
  }
  return changed;
}

}  // namespace

BorderedSolver::BorderedSolver(const HarmonicSpace& space, std::string name, SparseFactors factors)
    : line_(space.contact_line()), stiffness_(assemble_stiffness(space)), name_(std::move(name)), factors_(factors) {
  count_.n_dofs = space.n_dofs();
}

Eigen::VectorXd BorderedSolver::ring_means(const Eigen::VectorXd& field) const {
  return (line_.loads.transpose() * field(line_.dofs)).cwiseQuotient(line_.areas);
}

void BorderedSolver::factorise(const std::vector<bool>& interior) {
  if (factors_ == SparseFactors::kept && factor_ && interior == factored_) return;
  factor_.reset();  // two factors at once would double the memory
  factor_.emplace(bordered(stiffness_, line_, interior), name_);
  factored_ = interior;
  ++count_.n_factorisations;
}

BorderedSolver::Solution BorderedSolver::solve_rings(const Eigen::VectorXd& force, const Eigen::VectorXd& target,
                                                     const Eigen::VectorXd& at_bounds,
                                                     const std::vector<bool>& interior) {
  factorise(interior);
  const Eigen::Index n = stiffness_.n;
  Eigen::VectorXd rhs(n + n_rings());
  rhs.head(n) = -force;
  rhs(line_.dofs) += line_.loads * at_bounds;
  for (Eigen::Index i = 0; i < n_rings(); ++i)
    rhs[n + i] = interior[static_cast<std::size_t>(i)] ? -line_.areas[i] * target[i] : at_bounds[i];
  const Eigen::VectorXd unknowns = factor_->solve(rhs);
  ++count_.n_solves;
  Solution solution{unknowns.head(n), at_bounds, target};
  solution.residual -= ring_means(solution.field);
  for (Eigen::Index i = 0; i < n_rings(); ++i)
    if (interior[static_cast<std::size_t>(i)]) {
      solution.traction[i] = unknowns[n + i];
      solution.residual[i] = 0;
    }
  return solution;
}

BorderedSolver::Solution BorderedSolver::solve(const Eigen::VectorXd& force, const Eigen::VectorXd& target,
                                               const Eigen::VectorXd& lower, const Eigen::VectorXd& upper,
                                               std::vector<BoxState>& state) {
  for (int iteration = 0; iteration < iteration_limit; ++iteration) {
    Eigen::VectorXd at_bounds = Eigen::VectorXd::Zero(n_rings());
    std::vector<bool> interior(state.size());
    for (std::size_t i = 0; i < state.size(); ++i) {
      const auto ring = static_cast<Eigen::Index>(i);
      if (lower[ring] == upper[ring]) state[i] = BoxState::lower;
      interior[i] = state[i] == BoxState::interior;
      if (!interior[i]) at_bounds[ring] = state[i] == BoxState::lower ? lower[ring] : upper[ring];
    }
    Solution solution = solve_rings(force, target, at_bounds, interior);
    if (!change_violated(solution, lower, upper, line_.radii.back(), state)) return solution;
  }
  throw SolverError(name_ + ": the active set did not settle in " + std::to_string(iteration_limit) + " iterations");
}

}  // namespace fretval::fem
