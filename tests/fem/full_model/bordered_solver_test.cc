#include "fem/full_model/bordered_solver.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "fem/condensation/compliance.h"
#include "fem/condensation/condensation.h"
#include "fem/operators/stiffness.h"
#include "tests/fem/expect_solver_error.h"
#include "tests/fem/half_space.h"
#include "tests/fem/random_vector.h"

namespace fretval::fem::bordered_solver_test {
namespace {

using Eigen::Index;

constexpr Index n_rings = 8;

class BorderedSolverOf : public testing::TestWithParam<FourierOrder> {
 protected:
  HarmonicSpace space_{quarter_disc_grid(1, n_rings, 6, 0.35), GetParam(), 2};
  SparseMatrix stiffness_ = assemble_stiffness(space_);
  Condensation condensation_{stiffness_, space_.contact_line().dofs, "body"};
  Compliance compliance_ = contact_compliance(space_.contact_line(), condensation_.schur_complement());
  BorderedSolver bordered_{space_, "body"};
  std::vector<BoxState> state_ = std::vector<BoxState>(n_rings, BoxState::interior);
};

INSTANTIATE_TEST_SUITE_P(Harmonics, BorderedSolverOf, testing::Values(axisymmetric, lateral));

// Second method: BoxSolver on the compliance, q = areas times (target - ring means of -K^{-1} force).
TEST_P(BorderedSolverOf, SolvesTheBoxProblemOfTheCompliance) {
  const BoxSolver box(compliance_.matrix);
  const auto& areas = compliance_.areas;
  std::size_t n_at_bounds = 0;
  for (unsigned seed = 0; seed < 10; ++seed) {
    const Eigen::VectorXd target = random_vector(n_rings, seed);
    const Eigen::VectorXd limit = 10 * random_vector(n_rings, 20 + seed).cwiseAbs();
    Eigen::VectorXd force = Eigen::VectorXd::Zero(space_.n_dofs());
    for (const unsigned dof : space_.contact_line().dofs) force[dof] = 0.1 * std::sin(dof);
    const Eigen::VectorXd free = bordered_.ring_means(condensation_.solve(force));
    std::vector<BoxState> box_state(n_rings, BoxState::interior);
    const auto expected = box.solve(areas.cwiseProduct(target + free), -limit, 2 * limit, box_state);
    const auto solution = bordered_.solve(force, target, -limit, 2 * limit, state_);
    EXPECT_EQ(state_, box_state);
    EXPECT_LT((solution.traction - expected.x).cwiseAbs().maxCoeff(), 1e-12 * expected.x.cwiseAbs().maxCoeff());
    EXPECT_LT((areas.cwiseProduct(solution.residual) - expected.residual).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_LT((bordered_.ring_means(solution.field) - target + solution.residual).cwiseAbs().maxCoeff(), 1e-12);
    for (const auto at : state_) n_at_bounds += at == BoxState::interior ? 0 : 1;
  }
  EXPECT_GT(n_at_bounds, 20U);  // of 80: both kinds of rings occur
  EXPECT_LT(n_at_bounds, 60U);
}

TEST_P(BorderedSolverOf, FactorsAnInteriorOnce) {
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(space_.n_dofs());
  const Eigen::VectorXd wide = Eigen::VectorXd::Constant(n_rings, std::numeric_limits<double>::infinity());
  for (int k = 1; k < 4; ++k) {
    static_cast<void>(bordered_.solve(zero, random_vector(n_rings, 1), -wide, wide, state_));
    EXPECT_EQ(bordered_.count().n_factorisations, 1);
    EXPECT_EQ(bordered_.count().n_solves, k);
  }
  state_[3] = BoxState::lower;
  static_cast<void>(bordered_.solve(zero, random_vector(n_rings, 1), Eigen::VectorXd::Zero(n_rings), wide, state_));
  EXPECT_GT(bordered_.count().n_factorisations, 1);
}

TEST_P(BorderedSolverOf, NamesItselfInErrors) {
  Eigen::VectorXd target = Eigen::VectorXd::Ones(n_rings);
  target[2] = std::numeric_limits<double>::quiet_NaN();
  const Eigen::VectorXd wide = Eigen::VectorXd::Constant(n_rings, 9);
  expect_solver_error([&] { bordered_.solve(Eigen::VectorXd::Zero(space_.n_dofs()), target, -wide, wide, state_); },
                      {"body", "not finite"});
}

}  // namespace
}  // namespace fretval::fem::bordered_solver_test
