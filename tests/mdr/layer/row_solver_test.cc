#include "mdr/layer/row_solver.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <stdexcept>

namespace fretval::mdr::row_solver_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

const CoupledBed& bed() {
  static const CoupledBed made = coupled_bed(spring_bed(parabola(1), 1.2, 60), {0.3, 0.5});
  return made;
}

// A random problem, of contact or of friction.
RowProblem draw(std::mt19937& random, bool friction) {
  const Eigen::Index n = 60;
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto any = [&] { return Eigen::ArrayXd::NullaryExpr(n, [&] { return uniform(random); }); };
  const Eigen::ArrayXd most = 0.1 * any().abs();
  return {any(), 1 + 0.5 * any(), 1 + any().abs(), friction ? Eigen::ArrayXd(-most) : Eigen::ArrayXd::Zero(n),
          friction ? most : Eigen::ArrayXd::Constant(n, infinity)};
}

// Every load is at a limit with a rest that pushes it there, or between them without one.
void expect_solves(const RowProblem& problem, const RowSolution& found) {
  const Eigen::ArrayXd rest =
      problem.value + problem.slope * found.y - coupling(bed().normal, found.load) - problem.stretch * found.load;
  for (Eigen::Index j = 0; j < rest.size(); ++j) {
    EXPECT_GE(found.load[j], problem.lower[j]);
    EXPECT_LE(found.load[j], problem.upper[j]);
    if (found.load[j] > problem.lower[j]) {
      EXPECT_GT(rest[j], -1e-13);
    }
    if (found.load[j] < problem.upper[j]) {
      EXPECT_LT(rest[j], 1e-13);
    }
  }
}

TEST(RowSolver, FulfilsEveryConditionFromAnyStart) {
  std::mt19937 random{7};
  for (int i = 0; i < 300; ++i) {
    const RowProblem problem = draw(random, i % 2 == 0);
    const RowSolution cold = RowSolver(bed().normal).solve(problem, Eigen::ArrayXd::Zero(60), 0.3);
    expect_solves(problem, cold);
    EXPECT_EQ(cold.y, 0.3);
    const RowSolution warm = RowSolver(bed().normal).solve(problem, cold.load, 0.3);
    EXPECT_LT((warm.load - cold.load).abs().maxCoeff(), 1e-13);
  }
}

TEST(RowSolver, FindsThePositionOfASum) {
  std::mt19937 random{8};
  for (int i = 0; i < 300; ++i) {
    RowProblem problem = draw(random, i % 2 == 0);
    if (i % 2 == 0) problem.slope = problem.slope.abs();
    const double sum = i % 2 == 0 ? 0.7 * problem.upper.sum() : 3;
    const RowSolution found = RowSolver(bed().normal).solve(problem, Eigen::ArrayXd::Zero(60), 0.1, sum);
    expect_solves(problem, found);
    EXPECT_NEAR(found.load.sum(), sum, 1e-11);
  }
}

TEST(RowSolver, WithoutModesEverySpringIsByItself) {
  std::mt19937 random{9};
  const RowProblem problem = draw(random, true);
  const LayerModes none{Eigen::MatrixXd(60, 0), Eigen::ArrayXd(0)};
  const RowSolution found = RowSolver(none).solve(problem, Eigen::ArrayXd::Zero(60), 0.2);
  const Eigen::ArrayXd expected =
      ((problem.value + problem.slope * 0.2) / problem.stretch).max(problem.lower).min(problem.upper);
  EXPECT_EQ((found.load - expected).abs().maxCoeff(), 0);
  EXPECT_NEAR(RowSolver(none).solve(problem, Eigen::ArrayXd::Zero(60), 0.2, 0.5 * problem.upper.sum()).load.sum(),
              0.5 * problem.upper.sum(), 1e-12);
}

TEST(RowSolver, SaysThatNoPositionGivesASum) {
  std::mt19937 random{10};
  const RowProblem problem = draw(random, true);
  EXPECT_THROW(RowSolver(bed().normal).solve(problem, Eigen::ArrayXd::Zero(60), 0, 2 * problem.upper.sum()),
               std::invalid_argument);
}

}  // namespace
}  // namespace fretval::mdr::row_solver_test
