#include "mdr/layer/mode_equations.h"

#include <gtest/gtest.h>

#include <random>

namespace fretval::mdr::mode_equations_test {
namespace {

constexpr Eigen::Index n_springs = 100;

const LayerModes& modes() {
  static const CoupledBed bed = coupled_bed(spring_bed(parabola(1), 1.2, n_springs), {0.3, 0.5});
  return bed.normal;
}

void expect_solved(ModeEquations& equations, const Eigen::ArrayXd& give) {
  const Eigen::VectorXd rest = Eigen::VectorXd::LinSpaced(modes().strength.size(), -1, 2);
  equations.take(give);
  const Eigen::VectorXd x = equations.solve(rest);
  EXPECT_LT((x + modes().response(give) * x - rest).norm(), 1e-13 * rest.norm());
}

// A contact that grows spring by spring and shrinks again, with a rim that gives by less: corrections of any rank, and
// factors anew when there are too many.
TEST(ModeEquations, FollowTheEdgeOfAContact) {
  ModeEquations equations(modes());
  for (int step = 0; step < 200; ++step) {
    const Eigen::Index edge = 30 + (step < 100 ? step : 200 - step) / 2;
    Eigen::ArrayXd give = Eigen::ArrayXd::Zero(n_springs);
    give.head(edge) = 0.7;
    give[edge] = 0.35 + 1e-3 * step;
    expect_solved(equations, give);
  }
}

TEST(ModeEquations, TakeWhateverGives) {
  std::mt19937 random{3};
  std::uniform_real_distribution<double> uniform(0, 1);
  std::uniform_int_distribution<Eigen::Index> any(0, n_springs - 1), few(0, 12);
  ModeEquations equations(modes());
  Eigen::ArrayXd give = Eigen::ArrayXd::Zero(n_springs);
  for (int step = 0; step < 200; ++step) {
    for (Eigen::Index k = few(random); k > 0; --k) give[any(random)] = uniform(random);
    expect_solved(equations, give);
  }
}

TEST(ModeEquations, WithoutModesThereIsNothingToSolve) {
  const LayerModes none{Eigen::MatrixXd(n_springs, 0), Eigen::ArrayXd(0)};
  ModeEquations equations(none);
  equations.take(Eigen::ArrayXd::Ones(n_springs));
  EXPECT_EQ(equations.solve(Eigen::VectorXd(0)).size(), 0);
}

}  // namespace
}  // namespace fretval::mdr::mode_equations_test
