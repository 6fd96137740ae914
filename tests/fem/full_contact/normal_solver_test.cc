#include "fem/full_contact/normal_solver.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "fem/ring_contact/static_contact.h"
#include "tests/fem/full_contact/bodies.h"

namespace fretval::fem::normal_solver_test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using full_contact_test::surface_half_space;

TEST(NormalSolver, FindsThePressuresOfTheRingContact) {
  const auto& surface = surface_half_space(0.5);
  const ContactProblem rings(ring_compliance(surface, axisymmetric));
  const SurfaceOperator op(surface, angular_grid(5), SurfaceField::normal);
  const VectorXd profile = ring_means(rings.compliance, [](double r) { return r * r; });
  const auto expected = static_contact(rings, profile, 0.9);
  const MatrixXd target = (op.areas().array() * (0.9 - profile.array())).matrix().replicate(1, 5);
  const auto found = solve_pressure(op, target, MatrixXd::Zero(op.n_rings(), 5));
  EXPECT_LT((found.pressure - expected.pressure.replicate(1, 5)).norm(), 1e-10 * found.pressure.norm());
  const MatrixXd gap = op.areas().cwiseInverse().asDiagonal() * found.residual;
  EXPECT_LT((gap - expected.gap.replicate(1, 5)).norm(), 1e-10 * expected.gap.norm());
}

// An indenter that is not round, by the box solver with the whole matrix.
TEST(NormalSolver, FindsWhatTheBoxSolverFindsAlsoAroundTheAxis) {
  const SurfaceOperator op(surface_half_space(0.3), angular_grid(6), SurfaceField::normal);
  const Index n = op.n_rings() * 6;
  MatrixXd matrix(n, n), image, target(op.n_rings(), 6);
  for (Index i = 0; i < n; ++i) {
    MatrixXd unit = MatrixXd::Zero(op.n_rings(), 6);
    unit.data()[i] = 1;
    op.apply(unit, image);
    matrix.col(i) = Eigen::Map<const VectorXd>(image.data(), n);
  }
  for (Index i = 0; i < op.n_rings(); ++i)
    for (Index j = 0; j < 6; ++j) {
      const double r = (op.radii()[i] + op.radii()[i + 1]) / 2, x = r * std::cos(op.grid().angles[j]) - 0.1,
                   y = r * std::sin(op.grid().angles[j]);
      target(i, j) = op.areas()[i] * (0.5 - x * x - 2 * y * y);
    }
  const VectorXd q = Eigen::Map<const VectorXd>(target.data(), n);
  std::vector<BoxState> states(n, BoxState::interior);
  const auto expected = BoxSolver(matrix).solve(q, VectorXd::Zero(n), VectorXd::Constant(n, infinity), states);
  const auto found = solve_pressure(op, target, MatrixXd::Ones(op.n_rings(), 6));
  EXPECT_LT((Eigen::Map<const VectorXd>(found.pressure.data(), n) - expected.x).norm(), 1e-10 * expected.x.norm());
  EXPECT_GE(found.pressure.minCoeff(), 0);
  EXPECT_GE(found.residual.minCoeff(), 0);
}

TEST(NormalSolver, FindsNothingWhereNothingTouches) {
  const SurfaceOperator op(surface_half_space(0.5), angular_grid(4), SurfaceField::normal);
  const MatrixXd target = -op.areas().replicate(1, 4);
  const auto found = solve_pressure(op, target, MatrixXd::Ones(op.n_rings(), 4));
  EXPECT_EQ(found.pressure.norm(), 0);
  EXPECT_LT((found.residual + target).norm(), 1e-14);
}

TEST(NormalSolver, RefusesWhatDoesNotFit) {
  const SurfaceOperator op(surface_half_space(0.5), angular_grid(4), SurfaceField::normal);
  const MatrixXd none = MatrixXd::Zero(op.n_rings(), 4);
  EXPECT_THROW(solve_pressure(op, none, MatrixXd::Zero(op.n_rings(), 3)), std::invalid_argument);
  EXPECT_THROW(solve_pressure(op, none.array() + std::nan(""), none), std::invalid_argument);
}

}  // namespace
}  // namespace fretval::fem::normal_solver_test
