#include "fem/ring_contact/box_solver.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "tests/fem/expect_solver_error.h"
#include "tests/worse.h"

namespace fretval::fem::box_solver_test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double infinity = std::numeric_limits<double>::infinity();

struct BoxProblem {
  MatrixXd matrix;
  VectorXd q, lower, upper;
};

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double between(double a, double b) { return std::uniform_real_distribution<double>(a, b)(engine_); }
  int below(int n) { return std::uniform_int_distribution<int>(0, n - 1)(engine_); }
  BoxState state() { return static_cast<BoxState>(below(3) - 1); }

 private:
  std::mt19937 engine_;
};

std::vector<BoxState> random_states(Random& random, Index n) {
  std::vector<BoxState> states(static_cast<std::size_t>(n));
  for (auto& state : states) state = random.state();
  return states;
}

// Bounds of all kinds: two-sided, one-sided, none, fixed.
BoxProblem random_problem(Random& random, Index n) {
  MatrixXd root(n, n);
  VectorXd q(n), lower(n), upper(n);
  for (Index i = 0; i < n; ++i) {
    for (Index j = 0; j < n; ++j) root(i, j) = random.between(-1, 1);
    q[i] = random.between(-3, 3);
    lower[i] = random.between(-2, 0.5);
    upper[i] = lower[i] + random.between(0, 2);
    const int kind = random.below(5);
    if (kind == 0) upper[i] = infinity;
    if (kind == 1) lower[i] = -infinity;
    if (kind == 2) upper[i] = lower[i];
    if (kind == 3 && random.below(2) == 0) lower[i] = -infinity, upper[i] = infinity;
  }
  return {root * root.transpose() + 0.05 * MatrixXd::Identity(n, n), q, lower, upper};
}

/// Largest violation of the conditions of optimality; 0 at the solution.
double violation(const BoxProblem& problem, const VectorXd& x) {
  const VectorXd residual = problem.q - problem.matrix * x;
  double largest = 0;
  for (Index i = 0; i < x.size(); ++i) {
    largest = worse(largest, std::max(problem.lower[i] - x[i], x[i] - problem.upper[i]));
    // All conditions in one: x is the projection of x + residual onto the box.
    const double projected = std::min(std::max(x[i] + residual[i], problem.lower[i]), problem.upper[i]);
    largest = worse(largest, std::abs(projected - x[i]));
  }
  return largest;
}

VectorXd solve_with_states(const BoxProblem& problem, const std::vector<BoxState>& states) {
  const Index n = problem.q.size();
  MatrixXd matrix = problem.matrix;
  VectorXd rhs = problem.q;
  for (Index i = 0; i < n; ++i) {
    if (states[static_cast<std::size_t>(i)] == BoxState::interior) continue;
    matrix.row(i).setZero();
    matrix(i, i) = 1;
    rhs[i] = states[static_cast<std::size_t>(i)] == BoxState::lower ? problem.lower[i] : problem.upper[i];
  }
  return matrix.partialPivLu().solve(rhs);
}

/// All 3^n states, the best one: no idea shared with the solver.
VectorXd enumerate(const BoxProblem& problem) {
  const Index n = problem.q.size();
  const auto n_states = static_cast<int>(std::lround(std::pow(3, n)));
  VectorXd best;
  double least = infinity;
  for (int code = 0; code < n_states; ++code) {
    std::vector<BoxState> states;
    bool finite = true;
    for (int i = 0, rest = code; i < n; ++i, rest /= 3) {
      states.push_back(static_cast<BoxState>(rest % 3 - 1));
      if (states.back() == BoxState::lower) finite = finite && std::isfinite(problem.lower[i]);
      if (states.back() == BoxState::upper) finite = finite && std::isfinite(problem.upper[i]);
    }
    if (!finite) continue;
    const VectorXd x = solve_with_states(problem, states);
    const double violated = violation(problem, x);
    if (violated < least) best = x;
    least = std::min(least, violated);
  }
  return best;
}

// A test of the tests: what is no number fulfils nothing.
TEST(BoxSolver, ConditionsDoNotHoldForWhatIsNoNumber) {
  Random random(5);
  const BoxProblem problem = random_problem(random, 3);
  EXPECT_TRUE(std::isnan(violation(problem, VectorXd::Constant(3, std::nan("")))));
}

// Roundoff of matrices of condition up to 1e3: 2.5e-14 measured.
TEST(BoxSolver, FindsTheBestOfAllStates) {
  Random random(1);
  for (int trial = 0; trial < 300; ++trial) {
    const BoxProblem problem = random_problem(random, 1 + random.below(6));
    const VectorXd expected = enumerate(problem);
    ASSERT_LT(violation(problem, expected), 1e-10);
    auto states = random_states(random, problem.q.size());
    const auto solution = BoxSolver(problem.matrix).solve(problem.q, problem.lower, problem.upper, states);
    ASSERT_TRUE(solution.x.allFinite()) << "trial " << trial;
    EXPECT_LT((solution.x - expected).cwiseAbs().maxCoeff(), 1e-11) << "trial " << trial;
  }
}

// Roundoff: 7.5e-14 measured.
TEST(BoxSolver, FulfilsTheConditionsOfLargeProblems) {
  Random random(2);
  for (int trial = 0; trial < 40; ++trial) {
    const BoxProblem problem = random_problem(random, 20 + random.below(150));
    auto states = random_states(random, problem.q.size());
    const auto solution = BoxSolver(problem.matrix).solve(problem.q, problem.lower, problem.upper, states);
    EXPECT_LT(violation(problem, solution.x), 1e-11) << "trial " << trial;
    EXPECT_LT((problem.q - problem.matrix * solution.x - solution.residual).cwiseAbs().maxCoeff(), 1e-11);
    const MatrixXd factor = problem.matrix.llt().matrixL();
    EXPECT_LT((factor.transpose() * solution.x - solution.loads).cwiseAbs().maxCoeff(), 1e-11);
    for (Index i = 0; i < solution.x.size(); ++i) {
      const bool interior = states[static_cast<std::size_t>(i)] == BoxState::interior;
      if (interior) {
        EXPECT_EQ(solution.residual[i], 0);
      }
    }
  }
}

// The interior as a leading block, of any size from none to all, beside bounds that are not zero. Roundoff.
TEST(BoxSolver, SolvesLeadingInteriorSets) {
  Random random(7);
  constexpr Index n = 30;
  BoxProblem problem = random_problem(random, n);
  const MatrixXd factor = problem.matrix.llt().matrixL();
  for (Index k = 0; k <= n; ++k) {
    problem.lower.head(k).setConstant(-infinity);
    problem.upper.head(k).setConstant(infinity);
    problem.lower.tail(n - k) = problem.upper.tail(n - k) = VectorXd::LinSpaced(n - k, -1, 2);
    std::vector<BoxState> states(n, BoxState::interior);
    const BoxSolver solver(problem.matrix);
    BoxSolver::Target target{problem.q, {}};
    solver.hold(target);
    BoxSolver::Solution solution;
    solver.solve(target, problem.lower, problem.upper, states, solution);
    EXPECT_EQ(solution.iterations, 0);
    EXPECT_LT(violation(problem, solution.x), 1e-11) << k;
    EXPECT_LT((problem.q - problem.matrix * solution.x - solution.residual).cwiseAbs().maxCoeff(), 1e-11) << k;
    EXPECT_LT((factor.transpose() * solution.x - solution.loads).cwiseAbs().maxCoeff(), 1e-11) << k;
    EXPECT_LT((factor * target.held - problem.q).cwiseAbs().maxCoeff(), 1e-11);
  }
}

// A diagonal that is added is one of the matrix, wherever it begins and however few unknowns are factored.
TEST(BoxSolver, AddsADiagonal) {
  Random random(4);
  for (int trial = 0; trial < 60; ++trial) {
    const BoxProblem problem = random_problem(random, 2 + random.below(40));
    const Index n = problem.q.size(), first = random.below(static_cast<int>(n)),
                n_likely = random.below(static_cast<int>(n) + 1);
    VectorXd added = VectorXd::Zero(n);
    for (Index i = first; i < n; ++i) added[i] = random.below(3) == 0 ? 0 : std::pow(10, random.between(-3, 3));
    BoxProblem whole = problem;
    whole.matrix.diagonal() += added;
    auto states = random_states(random, n), same_states = states;
    const auto solution =
        BoxSolver(BoxSolver(problem.matrix), added, n_likely).solve(problem.q, problem.lower, problem.upper, states);
    const auto expected = BoxSolver(whole.matrix).solve(problem.q, problem.lower, problem.upper, same_states);
    EXPECT_LT(violation(whole, solution.x), 1e-10) << trial;
    EXPECT_LT((solution.x - expected.x).cwiseAbs().maxCoeff(), 1e-10) << trial;
    EXPECT_LT((solution.residual - expected.residual).cwiseAbs().maxCoeff(), 1e-9) << trial;
  }
}

// Every second unknown interior: what a leading block of the factor cannot solve alone.
TEST(BoxSolver, SolvesInteriorSetsWithGaps) {
  Random random(3);
  const Index n = 30;
  BoxProblem problem = random_problem(random, n);
  problem.lower.setConstant(-infinity);
  problem.upper.setConstant(infinity);
  for (Index i = 1; i < n; i += 2) problem.lower[i] = problem.upper[i] = random.between(-1, 1);
  std::vector<BoxState> states(n, BoxState::interior), expected_states = states;
  for (std::size_t i = 1; i < n; i += 2) expected_states[i] = BoxState::lower;
  const auto solution = BoxSolver(problem.matrix).solve(problem.q, problem.lower, problem.upper, states);
  const VectorXd expected = solve_with_states(problem, expected_states);
  EXPECT_LT((solution.x - expected).cwiseAbs().maxCoeff(), 1e-10 * expected.cwiseAbs().maxCoeff());
  EXPECT_TRUE(states == expected_states);
}

TEST(BoxSolver, StartsFromAnyState) {
  Random random(4);
  const BoxProblem problem = random_problem(random, 60);
  const BoxSolver solver(problem.matrix);
  std::vector<BoxState> first(60, BoxState::interior);
  const VectorXd x = solver.solve(problem.q, problem.lower, problem.upper, first).x;
  for (int trial = 0; trial < 20; ++trial) {
    auto states = random_states(random, 60);
    const auto solution = solver.solve(problem.q, problem.lower, problem.upper, states);
    EXPECT_LT((solution.x - x).cwiseAbs().maxCoeff(), 1e-10);
    EXPECT_TRUE(states == first);
  }
  EXPECT_EQ(solver.solve(problem.q, problem.lower, problem.upper, first).iterations, 0) << "the warm start is the end";
}

// Changing all violated unknowns at once goes round for ever here: {} -> {2} -> {0, 1, 2} -> {1} -> {2}. Single changes
// end at {1, 2}.
TEST(BoxSolver, EndsWhereBlockChangesCycle) {
  BoxProblem problem{MatrixXd(3, 3), VectorXd(3), VectorXd::Zero(3), VectorXd::Constant(3, infinity)};
  problem.matrix << 13, 18, -8, 18, 26, -10, -8, -10, 7;
  problem.q << -5, -2, 6;
  std::vector<BoxState> states(3, BoxState::lower);
  const auto solution = BoxSolver(problem.matrix).solve(problem.q, problem.lower, problem.upper, states);
  EXPECT_LT((solution.x - Eigen::Vector3d(0, 23.0 / 41, 68.0 / 41)).norm(), 1e-12);
  EXPECT_TRUE((states == std::vector<BoxState>{BoxState::lower, BoxState::interior, BoxState::interior}));
}

TEST(BoxSolver, RefusesLoadsThatAreNotFinite) {
  const BoxSolver solver(MatrixXd::Identity(3, 3).eval());
  const VectorXd lower = VectorXd::Zero(3), upper = VectorXd::Ones(3);
  for (const double bad : {std::nan(""), infinity}) {
    VectorXd q = VectorXd::Zero(3);
    q[1] = bad;
    std::vector<BoxState> states(3, BoxState::interior);
    EXPECT_THROW(solver.solve(q, lower, upper, states), std::invalid_argument);
  }
}

TEST(BoxSolver, RefusesBoundsThatAreNoNumbers) {
  const BoxSolver solver(MatrixXd::Identity(3, 3).eval());
  const VectorXd zero = VectorXd::Zero(3), ones = VectorXd::Ones(3);
  VectorXd bad = ones;
  bad[2] = std::nan("");
  std::vector<BoxState> states(3, BoxState::interior);
  EXPECT_THROW(solver.solve(zero, bad, ones, states), std::invalid_argument);
  EXPECT_THROW(solver.solve(zero, zero, bad, states), std::invalid_argument);
}

// The factor of a matrix whose triangles differ solves another problem than its columns state.
TEST(BoxSolver, NoticesThatItsAnswerDoesNotFulfilTheEquations) {
  MatrixXd matrix = MatrixXd::Identity(3, 3);
  matrix(0, 2) = 0.1;
  const VectorXd q = VectorXd::Ones(3), none = VectorXd::Constant(3, infinity);
  std::vector<BoxState> states(3, BoxState::interior);
  expect_solver_error([&] { BoxSolver(matrix).solve(q, -none, none, states); }, {"does not fulfil its equations"});
}

TEST(BoxSolver, RefusesAMatrixThatIsNotPositiveDefinite) {
  MatrixXd matrix = MatrixXd::Identity(3, 3);
  matrix(2, 2) = -1;
  expect_solver_error([&] { BoxSolver solver(matrix); }, {"not positive definite"});
}

// An unknown without a bound cannot start there.
TEST(BoxSolver, IgnoresAWarmStartAtAnInfiniteBound) {
  const VectorXd q = VectorXd::Constant(2, 3), none = VectorXd::Constant(2, infinity);
  for (const BoxState start : {BoxState::lower, BoxState::upper}) {
    std::vector<BoxState> states(2, start);
    const auto solution = BoxSolver(MatrixXd::Identity(2, 2).eval()).solve(q, -none, none, states);
    EXPECT_EQ(solution.x, q);
  }
}

}  // namespace
}  // namespace fretval::fem::box_solver_test
