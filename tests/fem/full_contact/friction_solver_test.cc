#include "fem/full_contact/friction_solver.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "fem/full_contact/projected_gradients.h"
#include "tests/fem/full_contact/bodies.h"

namespace fretval::fem::friction_solver_test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using full_contact_test::cattaneo_push;
using full_contact_test::hertz_pressure;
using full_contact_test::surface_half_space;

/// Areas times a displacement that is the same everywhere.
MatrixXd pull_by(const SurfaceOperator& op, double x, double y) {
  const Index m = op.grid().n_kept();
  MatrixXd pull(op.n_rings(), 2 * m);
  pull << op.areas().replicate(1, m) * x, op.areas().replicate(1, m) * y;
  return pull;
}

// What is kept of a problem must not stick to the next one, on fewer rings and under other limits.
TEST(FrictionSolver, SolvesOneProblemAfterAnotherAsEachByItself) {
  const SurfaceOperator op(surface_half_space(0.5), angular_grid(8), SurfaceField::tangential);
  const MatrixXd pressed = hertz_pressure(surface_half_space(0.5)).replicate(1, 8),
                 nothing = MatrixXd::Zero(op.n_rings(), 16);
  FrictionSolver solver(op);
  for (const double push : {0.2, 0.5, 0.7}) {
    MatrixXd limit = pressed / push;
    limit.bottomRows(static_cast<Index>(push * static_cast<double>(op.n_rings()))).setZero();
    const MatrixXd pull = pull_by(op, push, 0.3);
    const auto found = solver.solve(pull, limit, nothing), alone = FrictionSolver(op).solve(pull, limit, nothing);
    EXPECT_LT((found.traction - alone.traction).norm(), 1e-9 * alone.traction.norm()) << push;
  }
}

// Limits that vary around the axis, and a twist beside the push: nothing is left of any symmetry.
TEST(FrictionSolver, FindsWhatProjectedGradientsFind) {
  const SurfaceOperator op(surface_half_space(0.5), angular_grid(6), SurfaceField::tangential);
  MatrixXd limit = hertz_pressure(surface_half_space(0.5)).replicate(1, 6);
  for (Index j = 0; j < 6; ++j) limit.col(j) *= 1 + 0.3 * std::cos(op.grid().angles[j] - 1);
  MatrixXd pull = pull_by(op, 0.5, 0.2);
  pull.col(2) += 0.3 * op.areas();
  const auto found = FrictionSolver(op).solve(pull, limit, MatrixXd::Zero(op.n_rings(), 12));
  EXPECT_LT(found.remainder, 1e-11);
  const MatrixXd other = friction_by_projected_gradients(op, largest_eigenvalue(op), pull, limit);
  EXPECT_LT((found.traction - other).norm(), 1e-7 * found.traction.norm());
}

TEST(FrictionSolver, FulfilsCoulombsLawAtEveryPoint) {
  const SurfaceOperator op(surface_half_space(0.5), angular_grid(8), SurfaceField::tangential);
  const MatrixXd limit = hertz_pressure(surface_half_space(0.5)).replicate(1, 8), pull = pull_by(op, 0.4, 0.3);
  const auto found = FrictionSolver(op).solve(pull, limit, MatrixXd::Zero(op.n_rings(), 16));
  MatrixXd image;
  op.apply(found.traction, image);
  EXPECT_LT((pull - image - found.residual).norm(), 1e-13 * pull.norm());
  int n_stick = 0, n_slip = 0;
  for (Index i = 0; i < limit.rows(); ++i)
    for (Index j = 0; j < 8; ++j) {
      const double x = found.traction(i, j), y = found.traction(i, 8 + j), t = std::hypot(x, y),
                   slip_x = found.residual(i, j), slip_y = found.residual(i, 8 + j), slip = std::hypot(slip_x, slip_y);
      EXPECT_LE(t, limit(i, j) * (1 + 1e-12));
      if (limit(i, j) == 0) continue;
      if (t < limit(i, j) * (1 - 1e-9)) {
        EXPECT_LT(slip, 1e-10 * op.areas()[i]);
        ++n_stick;
      } else {
        EXPECT_NEAR(slip_x * x + slip_y * y, slip * t, 1e-12);
        ++n_slip;
      }
    }
  EXPECT_GT(n_stick, 8);
  EXPECT_GT(n_slip, 8);
}

// With one response to a traction in any direction a push along x leaves nothing across it, and is the ring contact's.
TEST(FrictionSolver, PushesAHalfSpaceWithoutPoissonsEffectAsCattaneoSays) {
  const auto& surface = surface_half_space(0, 16);
  const SurfaceOperator op(surface, angular_grid(8), SurfaceField::tangential);
  const double c = 0.6;
  const MatrixXd limit = hertz_pressure(surface).replicate(1, 8), pull = pull_by(op, cattaneo_push(c, 0), 0);
  const auto found = FrictionSolver(op).solve(pull, limit, MatrixXd::Zero(op.n_rings(), 16));
  const double force = (op.areas().transpose() * found.traction.leftCols(8)).sum();
  EXPECT_NEAR(force / (2 * pi / 3), 1 - c * c * c, 1e-3);                       // h^2
  EXPECT_LT(found.traction.rightCols(8).norm(), 2e-3 * found.traction.norm());  // cut off at 25, coarse
  const SurfaceOperator incompressible(surface_half_space(0.5, 16), angular_grid(8), SurfaceField::tangential);
  const auto other = FrictionSolver(incompressible).solve(pull, limit, MatrixXd::Zero(op.n_rings(), 16));
  EXPECT_GT(other.traction.rightCols(8).norm(), 2e-2 * other.traction.norm());
}

TEST(FrictionSolver, DoesNotDependOnItsGuess) {
  const SurfaceOperator op(surface_half_space(0.5), angular_grid(8), SurfaceField::tangential);
  const MatrixXd limit = hertz_pressure(surface_half_space(0.5)).replicate(1, 8), pull = pull_by(op, 0.4, 0.3);
  const auto found = FrictionSolver(op).solve(pull, limit, MatrixXd::Zero(op.n_rings(), 16));
  const auto other = FrictionSolver(op).solve(pull, limit, -100 * found.traction + MatrixXd::Random(op.n_rings(), 16));
  EXPECT_LT((found.traction - other.traction).norm(), 1e-10 * found.traction.norm());
}

// A motion that turns back pulls every point that slips to the other side of its disc.
TEST(FrictionSolver, TurnsBack) {
  const SurfaceOperator op(surface_half_space(0.5, 16), angular_grid(8), SurfaceField::tangential);
  const MatrixXd limit = hertz_pressure(surface_half_space(0.5, 16)).replicate(1, 8), pull = pull_by(op, 3, 0);
  const auto there = FrictionSolver(op).solve(pull, limit, MatrixXd::Zero(op.n_rings(), 16));
  EXPECT_NEAR(there.traction.leftCols(8).sum(), limit.sum(), 1e-3 * limit.sum());  // all of it slips
  const auto back = FrictionSolver(op).solve(-pull, limit, there.traction);
  EXPECT_LT((back.traction + there.traction).norm(), 1e-9 * there.traction.norm());
  EXPECT_LT(back.iterations, 12);
}

// Limits over four orders and pulls of any direction, from a guess of another problem.
TEST(FrictionSolver, ConvergesWhateverItIsAsked) {
  std::mt19937 random(1);
  const auto any = [&](double from, double to) { return std::uniform_real_distribution<double>(from, to)(random); };
  const SurfaceOperator op(surface_half_space(0.5, 16), angular_grid(8), SurfaceField::tangential);
  const auto field = [&](Index columns, double least, double most) {
    return MatrixXd(MatrixXd::NullaryExpr(op.n_rings(), columns, [&] { return any(least, most); }));
  };
  MatrixXd guess = MatrixXd::Zero(op.n_rings(), 16);
  for (int problem = 0; problem < 50; ++problem) {
    const MatrixXd limit = field(8, -4, 0).unaryExpr([](double x) { return std::pow(10, x); }),
                   pull = any(0.01, 3) * op.areas().asDiagonal() * field(16, -1, 1);
    const auto found = FrictionSolver(op).solve(pull, limit, guess);
    EXPECT_LE(found.remainder, 1e-10);
    guess = found.traction;
  }
}

TEST(FrictionSolver, HasNothingToDoWithoutLimits) {
  const SurfaceOperator op(surface_half_space(0.5), angular_grid(4), SurfaceField::tangential);
  const MatrixXd none = MatrixXd::Zero(op.n_rings(), 4), pull = pull_by(op, 0.4, 0.3);
  const auto found = FrictionSolver(op).solve(pull, none, pull);
  EXPECT_EQ(found.traction.norm(), 0);
  EXPECT_EQ(found.residual, pull);
}

TEST(FrictionSolver, RefusesWhatDoesNotFit) {
  const SurfaceOperator op(surface_half_space(0.5), angular_grid(4), SurfaceField::tangential);
  const MatrixXd limit = MatrixXd::Ones(op.n_rings(), 4), pull = pull_by(op, 0.4, 0.3);
  EXPECT_THROW(FrictionSolver(op).solve(limit, limit, pull), std::invalid_argument);
  EXPECT_THROW(FrictionSolver(op).solve(pull, pull, pull), std::invalid_argument);
  EXPECT_THROW(FrictionSolver(op).solve(pull, -limit, pull), std::invalid_argument);
  EXPECT_THROW(FrictionSolver(op).solve(pull * std::nan(""), limit, pull), std::invalid_argument);
}

}  // namespace
}  // namespace fretval::fem::friction_solver_test
